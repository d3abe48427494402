#pragma once

#include "regions/lattice/lattice_region.hpp"

namespace bempd::paper {

// Lattice of the scheme `paper`: bonds as published, without any correction at surfaces. Each point stands for a
// volume.
class UncorrectedLattice : public regions::LatticeRegion {
 public:
  using regions::LatticeRegion::LatticeRegion;

  // Always false, because published bodies have one lattice: two lattices are coupled only by the points that they
  // share.
  bool acts_as_one_with(const LatticeRegion&) const override { return false; }
  // Always empty, so that contact finds no places on crack faces: bond forces at surfaces and interfaces do not agree
  // with the stress there.
  std::optional<regions::LatticeGrid> lattice_grid() const override { return std::nullopt; }
  std::optional<pd::FaceLattice> face_lattice() const override { return std::nullopt; }
  // Makes the network of the region's own points; `cells` are not used.
  pd::Network make_network(const pd::CellLattice& cells, int threads) const override;

 protected:
  std::vector<char> shared_points(const regions::Preparation& preparation) const override;
  regions::FieldValues damage(const std::vector<char>& intact) const override;

 private:
  // Volumes of the points: full volumes for all points, also on interfaces and faces, because the published stretching
  // example has larger errors with smaller volumes.
  std::vector<double> volumes() const { return std::vector<double>(points_.size(), 1.0); }
};

}  // namespace bempd::paper
