#pragma once

namespace bempd {

// Result of work(). If it throws, undo() is called before the exception goes on.
template <class Work, class Undo>
decltype(auto) undone_on_failure(const Work& work, const Undo& undo) {
  try {
    return work();
  } catch (...) {
    undo();
    throw;
  }
}

// Calls work() and then undo(), which is called too if work() throws.
template <class Work, class Undo>
void undone_afterwards(const Work& work, const Undo& undo) {
  undone_on_failure(work, undo);
  undo();
}

}  // namespace bempd
