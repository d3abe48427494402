#include "bem/boundary_operator.hpp"

namespace bempd::bem {

int AssemblyOptions::threads_for(std::size_t elements) const {
  // Number of elements below which one thread does all: starting a second thread would take longer than the work.
  constexpr std::size_t worth_sharing = 64;
  if (elements < worth_sharing) return 1;
  return threads;
}

}  // namespace bempd::bem
