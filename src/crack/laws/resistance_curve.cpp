#include "crack/laws/resistance_curve.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace bempd::crack {

ResistanceCurve::ResistanceCurve(std::vector<double> extensions, std::vector<double> shares)
    : extensions_(std::move(extensions)), shares_(std::move(shares)) {
  for (std::size_t k = 0; k < extensions_.size(); ++k) {
    const double at = extensions_[k];
    require(std::isfinite(at) && at >= 0, "extension ", k + 1, " is ", at, "; it must be a finite number >= 0");
    require(k == 0 || at > extensions_[k - 1], "extension ", k + 1, " is ", at, ", not above the one before, ",
            extensions_[k == 0 ? 0 : k - 1], "; give them in ascending order");
  }
}

double ResistanceCurve::share(double grown) const {
  const auto behind = std::upper_bound(extensions_.begin(), extensions_.end(), grown);
  if (behind == extensions_.begin()) return shares_.front();
  if (behind == extensions_.end()) return shares_.back();
  const auto k = static_cast<std::size_t>(behind - extensions_.begin());
  const double way = (grown - extensions_[k - 1]) / (extensions_[k] - extensions_[k - 1]);
  return (1 - way) * shares_[k - 1] + way * shares_[k];
}

}  // namespace bempd::crack
