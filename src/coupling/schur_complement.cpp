#include "coupling/schur_complement.hpp"

#include <utility>

#include "error.hpp"

namespace bempd::coupling {

SchurComplement::SchurComplement(Stiffness stiffness, std::vector<DofKind> kind)
    : stiffness_(std::move(stiffness)), kind_(std::move(kind)) {
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    if (kind_[i] == DofKind::private_free) private_.push_back(static_cast<int>(i));
    if (kind_[i] == DofKind::shared_free) shared_.push_back(static_cast<int>(i));
  }
  matrix_ = (*stiffness_)(shared_, shared_);
}

void SchurComplement::fail_singular() {
  fail(
      Failure::unsolvable,
      "the stiffness of a boundary element region is numerically singular: strips of it, also those that holes, cracks "
      "and edges leave between them, that are thinner than some thousandth of their length bend without a resistance "
      "that numbers can tell from rounding: make them thicker or leave them out. If there are none, supports hardly "
      "hold "
      "the region");
}

}  // namespace bempd::coupling
