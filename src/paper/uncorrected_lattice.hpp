#pragma once

#include "regions/lattice/lattice_region.hpp"

namespace bempd::paper {

// A lattice of the scheme `paper`: bonds as published, without any correction at surfaces; points stand for volumes.
class UncorrectedLattice : public regions::LatticeRegion {
 public:
  using regions::LatticeRegion::LatticeRegion;

 protected:
  std::vector<char> shared_points(const regions::Preparation& preparation) const override;
  pd::Network make_network(int threads) const override;
  regions::FieldValues damage(const std::vector<char>& intact) const override;

 private:
  // Points on interfaces and faces count as full ones: with less, the published stretching example has larger errors.
  std::vector<double> volumes() const { return std::vector<double>(points_.size(), 1.0); }
};

}  // namespace bempd::paper
