#include "regions/boundary_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bem/boundary_loads.hpp"
#include "error.hpp"
#include "pd/face_loads.hpp"

namespace bempd::model {

namespace {

using coupling::Affine;

struct PartNode {
  int node;         // of the scene
  double fraction;  // of the part of the edge
};

// Nodes of a part of an edge, with its ends.
std::vector<PartNode> nodes_on(const Scene& scene, const Discretization& d, const EdgePart& part) {
  const Region& region = scene.region(part.region);
  const Edge edge = region.edge(part.edge);
  const double slack = 10 * d.tolerance / edge.length();
  std::vector<PartNode> found;
  const auto add = [&](int node, const Point& position) {
    const double along = closest_fraction(edge, position);
    if (along < part.from - slack || along > part.to + slack) return;
    found.push_back({node, std::clamp((along - part.from) / (part.to - part.from), 0.0, 1.0)});
  };
  if (const BoundaryPart* boundary = d.boundary_of(part.region)) {
    std::vector<char> wanted(boundary->mesh.nodes.size(), 0);
    for (const BoundaryElement& element : boundary->mesh.elements) {
      const PanelSource& panel = boundary->panels[element.panel];
      if (panel.edge != part.edge) continue;
      for (int node : element.nodes) wanted[node] = 1;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] && boundary->node_of_mesh_node[i] >= 0)
        add(boundary->node_of_mesh_node[i], boundary->mesh.nodes[i]);
    }
  } else {
    const LatticePart& lattice = *d.lattice_of(part.region);
    for (const LatticePart::EdgePoint& p : lattice.edge_points(part.edge)) {
      if (p.fraction < part.from - slack || p.fraction > part.to + slack) continue;
      const double along = (p.fraction - part.from) / (part.to - part.from);
      found.push_back({lattice.nodes[p.point], std::clamp(along, 0.0, 1.0)});
    }
  }
  return found;
}

int node_at(const Discretization& d, const Point& place) {
  int nearest = -1;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < d.positions.size(); ++i) {
    const double distance = (d.positions[i] - place).norm();
    if (distance < shortest) {
      shortest = distance;
      nearest = static_cast<int>(i);
    }
  }
  require(nearest >= 0 && shortest <= 10 * d.tolerance, "there is no node or material point at (", place.x(), ", ",
          place.y(), "); choose a place on a BEM boundary or a material point",
          nearest >= 0 ? text(", the nearest is (", d.positions[nearest].x(), ", ", d.positions[nearest].y(), ")")
                       : std::string());
  return nearest;
}

class SupportTable {
 public:
  SupportTable(const Discretization& d, DofConditions& conditions)
      : d_(d), c_(conditions), owner_(d.positions.size() * 2, -1) {}

  void prescribe(int support, int node, int component, const BoundaryValue& value) {
    const int dof = 2 * node + component;
    const Eigen::RowVector2d wanted(value.constant[component], value.proportional[component]);
    require(wanted.allFinite(), "support ", support + 1, " prescribes a displacement that is not a finite number at (",
            d_.positions[node].x(), ", ", d_.positions[node].y(), ")");
    require(d_.ties.tie_of(node) < 0, "support ", support + 1, " holds the material point at (", d_.positions[node].x(),
            ", ", d_.positions[node].y(),
            "), which follows the boundary elements of its interface; hold the boundary element region's edge instead");
    if (owner_[dof] < 0) {
      owner_[dof] = support;
      c_.prescribed[dof] = 1;
      c_.displacement.row(dof) = wanted;
      c_.reaction_dofs[support].push_back(dof);
      return;
    }
    const Eigen::RowVector2d present = c_.displacement.row(dof);
    const double scale = std::max(wanted.cwiseAbs().maxCoeff(), present.cwiseAbs().maxCoeff());
    require((wanted - present).cwiseAbs().maxCoeff() <= 1e-9 * scale, "supports ", owner_[dof] + 1, " and ",
            support + 1, " prescribe different displacements in ", component == 0 ? "x" : "y", " at (",
            d_.positions[node].x(), ", ", d_.positions[node].y(), "): ", present[0], " + ", present[1],
            " * load factor and ", wanted[0], " + ", wanted[1],
            " * load factor; let them agree, or end one of them before that place");
  }

 private:
  const Discretization& d_;
  DofConditions& c_;
  std::vector<int> owner_;
};

void apply_support(const Scene& scene, const Discretization& d, int support, SupportTable& table) {
  const Condition& condition = scene.supports()[support];
  std::vector<PartNode> nodes;
  if (const auto* part = std::get_if<EdgePart>(&condition.place)) {
    nodes = nodes_on(scene, d, *part);
    require(!nodes.empty(), "support ", support + 1, " holds no node: its part of edge ", part->edge, " of region ",
            part->region, " lies between two material points; widen it");
  } else {
    nodes.push_back({node_at(d, std::get<Point>(condition.place)), 0.0});
  }
  for (const PartNode& n : nodes) {
    const BoundaryValue value = condition.value(d.positions[n.node], n.fraction);
    for (int component = 0; component < 2; ++component) {
      if (condition.acts_on(component)) table.prescribe(support, n.node, component, value);
    }
  }
}

void require_free_edge(const Discretization& d, int load, const EdgePart& part, double edge_length) {
  for (const Contact& contact : d.arrangement.contacts) {
    if (contact.region != part.region - 1 || contact.edge != part.edge - 1) continue;
    const double shared = std::min(part.to, contact.to) - std::max(part.from, contact.from);
    require(shared * edge_length <= 10 * d.tolerance, "load ", load + 1, " puts a traction on edge ", part.edge,
            " of region ", part.region, ", which is an interface with region ", contact.other_region + 1, " from ",
            contact.from, " to ", contact.to, "; tractions act on free edges only");
  }
}

void apply_traction(const Scene& scene, const Discretization& d, int load, const EdgePart& part, Affine& force) {
  const Condition& condition = scene.loads()[load];
  const Region& region = scene.region(part.region);
  const Edge edge = region.edge(part.edge);
  const double thickness = scene.material(region.material).elasticity.thickness;
  require_free_edge(d, load, part, edge.length());
  for (int column = 0; column < 2; ++column) {
    const auto traction = [&](const Point& p) {
      const double along = std::clamp((closest_fraction(edge, p) - part.from) / (part.to - part.from), 0.0, 1.0);
      const BoundaryValue value = condition.value(p, along);
      Point result = column == 0 ? value.constant : value.proportional;
      for (int component = 0; component < 2; ++component) {
        if (!condition.acts_on(component)) result[component] = 0;
      }
      require(result.allFinite(), "load ", load + 1, " is not a finite number at (", p.x(), ", ", p.y(), ")");
      return result;
    };
    if (const BoundaryPart* boundary = d.boundary_of(part.region)) {
      Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(boundary->mesh.nodes.size()));
      for (std::size_t panel = 0; panel < boundary->panels.size(); ++panel) {
        const PanelSource& source = boundary->panels[panel];
        const double middle = 0.5 * (source.from + source.to);
        if (source.edge != part.edge || middle < part.from || middle > part.to) continue;
        bem::add_traction_forces(boundary->mesh, static_cast<int>(panel), traction, thickness, nodal);
      }
      const Eigen::VectorXd on_nodes = boundary->trace.transpose() * nodal;
      for (std::size_t i = 0; i < boundary->nodes.size(); ++i) {
        force.col(column).segment<2>(2 * boundary->nodes[i]) += on_nodes.segment<2>(2 * static_cast<Eigen::Index>(i));
      }
    } else {
      const LatticePart& lattice = *d.lattice_of(part.region);
      const auto& ends = lattice.outline.edges[part.edge - 1];
      const Segment piece{ends[0].cast<double>(), ends[1].cast<double>()};
      Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * lattice.point_count());
      const auto add_forces = lattice.cell_centred ? &pd::add_layer_forces : &pd::add_face_forces;
      const auto in_cells = [&](const Point& p) { return traction(lattice.outline.origin + lattice.spacing() * p); };
      add_forces(*lattice.lattice, piece.at(part.from), piece.at(part.to), in_cells,
                 nodal.head(2 * lattice.lattice->point_count()));
      nodal *= thickness * lattice.spacing();
      for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
        force.col(column).segment<2>(2 * lattice.nodes[i]) += nodal.segment<2>(2 * static_cast<Eigen::Index>(i));
      }
    }
  }
}

}  // namespace

DofConditions apply_conditions(const Scene& scene, const Discretization& d) {
  DofConditions c;
  const auto dofs = 2 * static_cast<Eigen::Index>(d.positions.size());
  c.prescribed.assign(dofs, 0);
  c.displacement = c.force = Affine::Zero(dofs, 2);
  c.reaction_dofs.resize(scene.supports().size());
  SupportTable table(d, c);
  for (std::size_t s = 0; s < scene.supports().size(); ++s) apply_support(scene, d, static_cast<int>(s), table);
  for (std::size_t l = 0; l < scene.loads().size(); ++l) {
    const Condition& load = scene.loads()[l];
    if (const auto* part = std::get_if<EdgePart>(&load.place)) {
      apply_traction(scene, d, static_cast<int>(l), *part, c.force);
      continue;
    }
    const Point& place = std::get<Point>(load.place);
    const int node = node_at(d, place);
    const BoundaryValue value = load.value(place, 0.0);
    for (int component = 0; component < 2; ++component) {
      if (!load.acts_on(component)) continue;
      c.force(2 * node + component, 0) += value.constant[component];
      c.force(2 * node + component, 1) += value.proportional[component];
    }
  }
  return c;
}

}  // namespace bempd::model
