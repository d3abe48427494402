#pragma once

#include "regions/lattice/lattice_region.hpp"

namespace bempd::paper {

// Lattice of the scheme `paper`: bonds as published, without any correction at surfaces. Each point stands for a
// volume.
class UncorrectedLattice : public regions::LatticeRegion {
 public:
  using regions::LatticeRegion::LatticeRegion;

  // Never true: published bodies have one lattice, so two lattices are coupled only by the points they share.
  bool acts_as_one_with(const LatticeRegion&) const override { return false; }
  // Empty, so that contact has no face places here: bond forces at surfaces and interfaces are not those of the stress
  // there.
  std::optional<regions::LatticeGrid> lattice_grid() const override { return std::nullopt; }
  std::optional<pd::FaceLattice> face_lattice() const override { return std::nullopt; }
  // Makes the network of the region's own points, whatever the cells are.
  pd::Network make_network(const pd::CellLattice& cells, int threads) const override;

 protected:
  std::vector<char> shared_points(const regions::Preparation& preparation) const override;
  regions::FieldValues damage(const std::vector<char>& intact) const override;

 private:
  // Volumes of the points, all of them full ones, also on interfaces and faces: with less, the published stretching
  // example has larger errors.
  std::vector<double> volumes() const { return std::vector<double>(points_.size(), 1.0); }
};

}  // namespace bempd::paper
