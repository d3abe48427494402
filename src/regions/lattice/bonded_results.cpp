#include <array>

#include "error.hpp"
#include "pd/deformation.hpp"
#include "regions/lattice/bonded_region.hpp"

namespace bempd::regions {

std::vector<std::uint8_t> BondedRegion::broken_bonds(const std::vector<char>& intact) const {
  std::vector<std::uint8_t> broken(network()->bonds.size());
  for (std::size_t b = 0; b < broken.size(); ++b) broken[b] = intact[scene_bond(b)] ? 0 : 1;
  return broken;
}

FieldSize BondedRegion::field_size(Field field) const {
  require(field != Field::traction && field != Field::element_stress, "region ", id(),
          " is peridynamic and has no tractions and no boundary elements; ask a BEM region");
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
      return bond_stretch(solution);
    case Field::traction:
    case Field::element_stress:  // refused by field_size()
    case Field::stress_order:    // a matter of the whole scene
      break;
  }
  return {};
}

FieldValues BondedRegion::damage(const std::vector<char>& intact) const {
  std::vector<int> all(points_.size() + bonds_.far_points.size(), 0), left(all.size(), 0);
  for (std::size_t b = 0; b < network()->bonds.size(); ++b) {
    for (int point : {network()->bonds[b].first, network()->bonds[b].second}) {
      ++all[point];
      left[point] += intact[scene_bond(b)];
    }
  }
  FieldValues field{std::vector<double>(points_.size(), 0.0), 1};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (all[i] > 0) field.values[i] = 1 - static_cast<double>(left[i]) / all[i];
  }
  return field;
}

pd::BondStates BondedRegion::bond_states(const Solution& solution) const {
  const coupling::Terms& terms = solution.bonds;
  pd::BondStates states;
  for (std::size_t b = 0; b < network()->bonds.size(); ++b) {
    const std::size_t term = scene_bond(b);
    const double share = !solution.intact[term] ? 0
                         : solution.stages      ? terms.law_of(term).stiffness_share((*solution.stages)[term])
                                                : 1;
    states.share.push_back(share);
    if (!terms.have_offsets()) continue;
    const double rest = terms.rest(term, 0) + solution.load_factor * terms.rest(term, 1);
    states.rest_stretch.push_back(rest / terms.length[term]);
  }
  return states;
}

FieldValues BondedRegion::stress(const Solution& solution) const {
  const int own = point_count(), count = own + static_cast<int>(bonds_.far_nodes.size());
  Eigen::VectorXd displacement(2 * count);
  displacement.head(2 * own) = gather(solution.displacement);
  for (int i = own; i < count; ++i)
    displacement.segment<2>(2 * i) = solution.displacement.segment<2>(2 * bonds_.far_nodes[i - own]);
  displacement /= spacing();
  const pd::BondStates states = bond_states(solution);
  auto strains = pd::bond_strains(count, *network(), states, displacement);
  strains.resize(own);  // at the others some bonds are missing
  std::vector<Eigen::Vector3d> stresses;
  stresses.reserve(strains.size());
  for (const Eigen::Vector3d& strain : strains) stresses.push_back(pd::stress_of(strain, elasticity()));
  correct_at_losses(solution, strains, states, stresses);
  FieldValues field{{}, 3};
  for (const Eigen::Vector3d& stress : stresses)
    field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
  return field;
}

FieldValues BondedRegion::bond_stretch(const Solution& solution) const {
  FieldValues field{{}, 1};
  for (std::size_t b = bonds_.first; b < bonds_.first + bonds_.listed; ++b)
    field.values.push_back(solution.bonds.elastic_elongation(b, solution.displacement.data(), solution.load_factor) /
                           solution.bonds.length[b]);
  return field;
}

std::vector<Point> BondedRegion::positions() const {
  std::vector<Point> all;
  all.reserve(static_cast<std::size_t>(point_count()));
  for (int i = 0; i < point_count(); ++i) all.push_back(position(i));
  return all;
}

// Cells of the region for a picture, split along broken bonds between neighbouring points.
RegionPicture BondedRegion::picture(const Solution& solution) const {
  const std::vector<std::uint8_t> broken = broken_bonds(solution.intact);
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
