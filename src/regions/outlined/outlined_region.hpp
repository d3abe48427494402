#pragma once

#include <memory>
#include <vector>

#include "pd/outlined/cell_stencils.hpp"
#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/bonded_region.hpp"
#include "regions/lattice/peridynamic_description.hpp"

namespace bempd::regions {

// Peridynamic region with any outline: material points on equal chords along its edges and, inside, on a lattice.
// Uniform stress is in balance with the tractions on the chords, which coincide with straight edges.
class OutlinedRegion final : public BondedRegion {
 public:
  OutlinedRegion(int id, const PeridynamicDescription& described, const scene::Material& material);

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;
  void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const override;

  std::vector<Point> interface_points(const Preparation& preparation, const Contact& own) override;

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;

  std::optional<LatticeGrid> lattice_grid() const override;
  void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
           std::vector<std::string>& warnings) const override;
  std::optional<pd::FaceLattice> face_lattice() const override {
    return pd::FaceLattice{from_grid(body_.place.origin), spacing(), choice_.angle};
  }

  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;

  std::int64_t cell_count() const override { return static_cast<std::int64_t>(body_.cells.size()); }
  Cells cells() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;

 protected:
  std::vector<double> cell_shares() const override { return body_.areas; }

 private:
  class CellEvaluator;
  // Piece of an edge that is divided into equal chords.
  struct Piece {
    int edge;  // number
    double from, to;
    Arc arc;  // in grid coordinates
  };

  // Terms called squares of cells (outlined_squares.cpp).
  void add_squares(const Contributions& contributions);
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const override;
  // Mean stress [Pa] that the squares cause in a patch of cells.
  Eigen::Vector3d stress_of_squares(const Solution& solution, std::size_t patch) const;

  void require_common_points(const Preparation& preparation, const Contact& contact) const;
  void divide_outline(const Preparation& preparation);
  std::vector<char> pieces_that_may_vary(const Preparation& preparation) const;
  // Flags of material points that are nodes of other regions too: all points on matching interfaces, only the end
  // points of others. The surface vectors of these points are marked to be kept when the outline is balanced.
  std::vector<char> shared_points(const Preparation& preparation);
  // Fractions of an edge at which pieces end: the ends of interfaces, and other required places where there is room for
  // chords.
  std::vector<double> stations_on(const Preparation& preparation, int edge) const;
  pd::LatticePlace place_of_lattice(const Preparation& preparation) const;
  void require_possible_corners() const;
  double fraction(const pd::Chord& chord, double part) const;
  template <class Visit>
  void for_chords_on(const EdgeSpan& span, const Visit& visit) const;

  PointChoice choice_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Arc>> loops_;
  pd::OutlinedBody body_;
  pd::CellStencils stencils_;  // empty where bonds alone make the material
};

}  // namespace bempd::regions
