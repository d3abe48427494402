#include "bem/boundary_operator.hpp"

namespace bempd::bem {

int AssemblyOptions::threads_for(std::size_t elements) const {
  // A few milliseconds of work: less is done before a second thread has started on a busy machine.
  constexpr std::size_t worth_sharing = 64;
  if (elements < worth_sharing) return 1;
  return threads;
}

}  // namespace bempd::bem
