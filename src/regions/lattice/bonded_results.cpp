#include <array>
#include <numeric>

#include "error.hpp"
#include "pd/deformation.hpp"
#include "regions/lattice/bonded_region.hpp"

namespace bempd::regions {

std::vector<int> BondedRegion::entries_of_nodes() const {
  std::vector<int> entries(nodes_.size());
  std::iota(entries.begin(), entries.end(), 0);
  return entries;
}

FieldSize BondedRegion::field_size(Field field) const {
  require(field != Field::traction && field != Field::element_stress, "region ", id(),
          " is peridynamic and has no tractions and no boundary elements; ask "
          "a BEM region");
  const std::int64_t count = field == Field::bond_stretch ? static_cast<std::int64_t>(bonds_.listed) : point_count();
  return {count, components_of(field)};
}

FieldValues BondedRegion::field(Field field, const Solution& solution) const {
  switch (field) {
    case Field::position: {
      FieldValues positions{{}, 2};
      for (int i = 0; i < point_count(); ++i) {
        const Point p = position(i);
        positions.values.insert(positions.values.end(), {p.x(), p.y()});
      }
      return positions;
    }
    case Field::displacement: {
      const Eigen::VectorXd values = gather(solution.displacement);
      return {{values.data(), values.data() + values.size()}, 2};
    }
    case Field::damage:
      return damage(solution.intact);
    case Field::stress:
      return stress(solution);
    case Field::bond_stretch:
      return {bonds_.stretch(solution), 1};
    case Field::traction:
    case Field::element_stress:  // refused by field_size()
    case Field::stress_order:    // a matter of the whole scene
      break;
  }
  return {};
}

FieldValues BondedRegion::damage(const std::vector<char>& intact) const {
  return {bonds_.damage(intact, points_.size()), 1};
}

FieldValues BondedRegion::stress(const Solution& solution) const {
  const int own = point_count(), count = own + static_cast<int>(bonds_.far_nodes.size());
  Eigen::VectorXd displacement(2 * count);
  displacement.head(2 * own) = gather(solution.displacement);
  for (int i = own; i < count; ++i)
    displacement.segment<2>(2 * i) = solution.displacement.segment<2>(2 * bonds_.far_nodes[i - own]);
  displacement /= spacing();
  const pd::BondStates states = bonds_.states(solution);
  auto strains = pd::bond_strains(count, *network(), states, displacement);
  strains.resize(own);  // only own points have all of their bonds
  std::vector<Eigen::Vector3d> stresses;
  stresses.reserve(strains.size());
  for (const Eigen::Vector3d& strain : strains) stresses.push_back(pd::stress_of(strain, elasticity()));
  if (squares()) squares()->correct_at_losses(solution, strains, states, stresses);
  FieldValues field{{}, 3};
  for (const Eigen::Vector3d& stress : stresses)
    field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
  return field;
}

// Cells of the region for a picture, split along broken bonds between neighbouring points.
RegionPicture BondedRegion::picture(const Solution& solution) const {
  const std::vector<std::uint8_t> broken = bonds_.broken(solution.intact);
  std::vector<std::array<int, 2>> parted;
  for (std::size_t b = 0; b < broken.size(); ++b) {
    const pd::Bond& bond = network()->bonds[b];
    if (broken[b] && bond.first < point_count() && bond.second < point_count())
      parted.push_back({bond.first, bond.second});
  }
  const Cells whole = cells();
  if (parted.empty()) return {{}, whole};
  SplitCells split = split_cells(positions(), whole.nodes, parted);
  return {std::move(split.added), {whole.nodes_per_cell, std::move(split.nodes)}};
}

SnapshotBlock BondedRegion::snapshot_block() const {
  return {"lattice",
          0,
          output::VtuCell::quad,
          {{"displacement", Field::displacement}, {"damage", Field::damage}, {"stress", Field::stress}}};
}

}  // namespace bempd::regions
