#include "bem/crack_mesh.hpp"

#include <algorithm>

#include "error.hpp"

namespace bempd::bem {

namespace {

struct Mouth {
  int before = -1, after = -1;  // boundary nodes before and behind the mouth
};

// Splits the boundary node at a crack mouth into two nodes. The part of the boundary that ends at the mouth keeps the
// old node; elements that start at the mouth get the new node.
Mouth split_at(const Point& place, BoundaryMesh& mesh, double tolerance) {
  Mouth mouth;
  double least = 16 * tolerance;
  for (const BoundaryElement& element : mesh.elements) {
    const double gap = (mesh.nodes[element.nodes[0]] - place).norm();
    if (gap > least) continue;
    least = gap;
    mouth.before = element.nodes[0];
  }
  require(mouth.before >= 0, "a crack reaches the boundary at (", place.x(), ", ", place.y(),
          "), where no element ends; elements of that edge have to end there");
  mouth.after = static_cast<int>(mesh.nodes.size());
  mesh.nodes.push_back(mesh.nodes[mouth.before]);
  for (BoundaryElement& element : mesh.elements)
    if (element.nodes[0] == mouth.before) element.nodes[0] = mouth.after;
  return mouth;
}

// Opening node at an end of a crack line that lies at a joint. Its openings count with the sign 1 if this is the start
// of the line, else with -1.
struct OpeningAtJoint {
  int node;
  double sign;
};

class Mesher {
 public:
  Mesher(const CrackLines& cracks, BoundaryMesh& boundary, double tolerance)
      : cracks_(cracks), boundary_(boundary), openings_at_joint_(cracks.joints.size()), mouths_(cracks.joints.size()) {
    for (std::size_t j = 0; j < cracks.joints.size(); ++j) {
      places_.push_back(cracks.joints[j].place);
      mesh.mouth_of_joint.push_back({-1, -1});
      if (!cracks.joints[j].mouth) continue;
      mouths_[j] = split_at(places_[j], boundary, tolerance);
      mesh.mouth_of_joint[j] = {mouths_[j].before, mouths_[j].after};
      places_[j] = boundary.nodes[mouths_[j].before];
    }
    for (const BoundaryElement& e : boundary.elements)
      mesh.first_face_panel = std::max(mesh.first_face_panel, e.panel + 1);
    next_panel_ = mesh.first_face_panel;
    mesh.pieces = find_pieces(cracks, boundary, mesh.mouth_of_joint);
    line_nodes_.assign(cracks.lines.size(), {-1, -1});
    for (std::size_t j = 0; j < cracks.joints.size(); ++j) add_sectors(static_cast<int>(j));
  }

  bool is_cut(int l) const { return mesh.pieces.is_cut(l); }

  // Adds the two faces of line `l`, which separates two pieces of the body, to the boundary.
  void add_cut(int l, const std::vector<double>& stations) {
    const CrackLine& line = cracks_.lines[l];
    const int count = static_cast<int>(stations.size()) - 1;
    std::vector<int> left{sector_beside(l, 0, true)}, right{sector_beside(l, 0, false)};
    for (int e = 0; e < count; ++e) {
      const Point start = place(line, stations, e), end = place(line, stations, e + 1);
      for (auto* face : {&left, &right}) {
        face->push_back(add_node(0.5 * (start + end)));
        const bool last = e + 1 == count;
        face->push_back(last ? sector_beside(l, 1, face == &left) : add_node(end));
      }
      mesh.cuts.push_back({l,
                           stations[e],
                           stations[e + 1],
                           {left[2 * e], left[2 * e + 1], left[2 * e + 2]},
                           {right[2 * e], right[2 * e + 1], right[2 * e + 2]}});
    }
    add_face(line, stations, left, mesh.pieces.left_of(l));
    std::reverse(right.begin(), right.end());
    std::vector<double> backwards;
    for (int k = count; k >= 0; --k) backwards.push_back(stations[k]);
    add_face(line, backwards, right, mesh.pieces.right_of(l));
  }

  void add_line(int l, const std::vector<double>& stations) {
    const CrackLine& line = cracks_.lines[l];
    const int first = static_cast<int>(mesh.nodes.size()), count = static_cast<int>(stations.size()) - 1;
    for (int e = 0; e < count; ++e) {
      const Point start = place(line, stations, e), end = place(line, stations, e + 1);
      TipEnd tip = TipEnd::none;
      if (e == 0 && line.joints[0] < 0) tip = TipEnd::start;
      if (e + 1 == count && line.joints[1] < 0) tip = TipEnd::end;
      const int node = first + 2 * e;
      if (e == 0) mesh.nodes.push_back(start);
      // The mid node of an element at a tip is a quarter of the element's length away from the tip.
      const double middle = tip == TipEnd::start ? 0.25 : tip == TipEnd::end ? 0.75 : 0.5;
      mesh.nodes.push_back(start + middle * (end - start));
      mesh.nodes.push_back(end);
      mesh.elements.push_back(
          {{node, node + 1, node + 2}, l, stations[e], stations[e + 1], tip, mesh.pieces.left_of(l)});
      if (tip != TipEnd::none) add_tip(l, tip, start, end);
    }
    mesh.joint_of_node.resize(mesh.nodes.size(), -1);
    add_end(line.joints[0], first, 1);
    add_end(line.joints[1], first + 2 * count, -1);
    line_nodes_[l] = {first, first + 2 * count};
  }

  void constrain(int boundary_nodes) {
    const int raw = static_cast<int>(mesh.nodes.size());
    std::vector<int> column(raw, -1);
    std::vector<char> removed(raw, 0);
    for (const CrackTip& tip : mesh.tips) {
      const CrackElement& element = mesh.elements[tip.element];
      removed[element.nodes[tip.end == TipEnd::start ? 0 : 2]] = 1;
    }
    for (std::size_t j = 0; j < openings_at_joint_.size(); ++j) {
      if (!sectors_[j].empty())
        for (const OpeningAtJoint& opening : openings_at_joint_[j]) removed[opening.node] = 1;
      if (!openings_at_joint_[j].empty()) removed[openings_at_joint_[j].back().node] = 1;
    }
    for (int n = 0; n < raw; ++n)
      if (!removed[n]) column[n] = boundary_nodes + mesh.free_nodes++;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int node, int from, double factor) {
      for (int c = 0; c < 2; ++c) entries.emplace_back(2 * node + c, 2 * from + c, factor);
    };
    for (int n = 0; n < raw; ++n)
      if (!removed[n]) add(n, column[n], 1);
    for (std::size_t j = 0; j < openings_at_joint_.size(); ++j) {
      if (openings_at_joint_[j].empty()) continue;
      if (!sectors_[j].empty()) {
        open_between_sectors(static_cast<int>(j), add);
        continue;
      }
      const OpeningAtJoint last = openings_at_joint_[j].back();
      for (std::size_t m = 0; m + 1 < openings_at_joint_[j].size(); ++m)
        add(last.node, column[openings_at_joint_[j][m].node], -last.sign * openings_at_joint_[j][m].sign);
      if (mouths_[j].before < 0) continue;
      add(last.node, mouths_[j].before, last.sign);
      add(last.node, mouths_[j].after, -last.sign);
    }
    mesh.constraint.resize(2 * raw, 2 * (boundary_nodes + mesh.free_nodes));
    mesh.constraint.setFromTriplets(entries.begin(), entries.end());
  }

  CrackMesh mesh;

 private:
  // Place of station number `k` on a line. At the ends of the line it is exactly the place of the joint.
  Point place(const CrackLine& line, const std::vector<double>& stations, int k) const {
    if (k == 0) return line.joints[0] < 0 ? line.points.front() : places_[line.joints[0]];
    if (k + 1 == static_cast<int>(stations.size()))
      return line.joints[1] < 0 ? line.points.back() : places_[line.joints[1]];
    double before = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const Segment segment{line.points[i], line.points[i + 1]};
      const double length = segment.length();
      if (stations[k] <= before + length || i + 2 == line.points.size())
        return segment.at(std::min(1.0, (stations[k] - before) / length));
      before += length;
    }
    return line.points.back();
  }

  // Adds boundary nodes around a joint at which a line between two pieces ends. The lines at the joint divide the body
  // into sectors, each with a node of its own. `sectors_` gets these nodes counter-clockwise: the node before each
  // line, then the node behind the last line. At a crack mouth the first and the last node are those of the boundary;
  // inside the body they are the same node.
  void add_sectors(int joint) {
    const std::vector<LineEnd>& around = mesh.pieces.around[joint];
    sectors_.emplace_back();
    mesh.nodes_at_joint.emplace_back();
    const bool mouth = mouths_[joint].before >= 0;
    if (mouth) mesh.nodes_at_joint.back() = {mouths_[joint].before, mouths_[joint].after};
    if (std::none_of(around.begin(), around.end(), [&](const LineEnd& e) { return is_cut(e.line); })) return;
    std::vector<int>& sectors = sectors_.back();
    for (std::size_t k = 0; k < around.size(); ++k) {
      if (mouth && k == 0) {
        sectors.push_back(mouths_[joint].after);
        continue;
      }
      sectors.push_back(add_node(places_[joint]));
      mesh.nodes_at_joint.back().push_back(sectors.back());
    }
    sectors.push_back(mouth ? mouths_[joint].before : sectors.front());
  }

  // Boundary node of the sector on the left or the right of a line at its start (`end` 0) or its end (1).
  int sector_beside(int line, int end, bool left) const {
    const int joint = cracks_.lines[line].joints[end];
    const std::vector<LineEnd>& around = mesh.pieces.around[joint];
    const auto own =
        std::find_if(around.begin(), around.end(), [&](const LineEnd& e) { return e.line == line && e.end == end; });
    const bool behind = left == (end == 0);
    return sectors_[joint][static_cast<std::size_t>(own - around.begin()) + (behind ? 1 : 0)];
  }

  template <class Add>
  void open_between_sectors(int joint, const Add& add) const {
    for (const LineEnd& e : mesh.pieces.around[joint]) {
      if (is_cut(e.line)) continue;
      add(line_nodes_[e.line][e.end], sector_beside(e.line, e.end, true), 1);
      add(line_nodes_[e.line][e.end], sector_beside(e.line, e.end, false), -1);
    }
  }

  int add_node(const Point& place) {
    boundary_.nodes.push_back(place);
    return static_cast<int>(boundary_.nodes.size()) - 1;
  }

  // Adds the boundary elements of a crack face with the given nodes. A new panel begins where the line turns, because
  // tractions jump at corners.
  void add_face(const CrackLine& line, const std::vector<double>& stations, const std::vector<int>& nodes, int piece) {
    const auto segment_at = [&](double way) {
      std::size_t segment = 0;
      for (double end = 0; segment + 2 < line.points.size(); ++segment)
        if (way < (end += (line.points[segment + 1] - line.points[segment]).norm())) break;
      return segment;
    };
    std::size_t segment = line.points.size();
    for (std::size_t e = 0; e + 1 < stations.size(); ++e) {
      const std::size_t own = segment_at(0.5 * (stations[e] + stations[e + 1]));
      if (own != segment) ++next_panel_, ++boundary_.traction_node_count;
      segment = own;
      const int traction = boundary_.traction_node_count - 1;
      boundary_.elements.push_back({{nodes[2 * e], nodes[2 * e + 1], nodes[2 * e + 2]},
                                    {traction, traction + 1, traction + 2},
                                    next_panel_ - 1});
      boundary_.traction_node_count += 2;
      mesh.pieces.of_element.push_back(piece);
    }
  }

  void add_tip(int line, TipEnd end, const Point& from, const Point& to) {
    const Point along = (to - from).normalized();
    const int element = static_cast<int>(mesh.elements.size()) - 1;
    mesh.tips.push_back(end == TipEnd::start ? CrackTip{element, line, end, from, -along}
                                             : CrackTip{element, line, end, to, along});
  }

  void add_end(int joint, int node, double sign) {
    if (joint < 0) return;
    openings_at_joint_[joint].push_back({node, sign});
    mesh.joint_of_node[node] = joint;
  }

  const CrackLines& cracks_;
  BoundaryMesh& boundary_;
  std::vector<std::vector<OpeningAtJoint>> openings_at_joint_;
  std::vector<Mouth> mouths_;
  std::vector<Point> places_;
  std::vector<std::vector<int>> sectors_;       // sector nodes of each joint where pieces meet
  std::vector<std::array<int, 2>> line_nodes_;  // opening nodes at start and end of lines inside pieces
  int next_panel_ = 0;
};

}  // namespace

CrackMesh mesh_cracks(const CrackLines& cracks, const std::vector<std::vector<double>>& stations,
                      BoundaryMesh& boundary, double tolerance) {
  Mesher mesher(cracks, boundary, tolerance);
  for (int l = 0; l < static_cast<int>(cracks.lines.size()); ++l) {
    if (mesher.is_cut(l))
      mesher.add_cut(l, stations[l]);
    else
      mesher.add_line(l, stations[l]);
  }
  mesher.constrain(static_cast<int>(boundary.nodes.size()));
  return std::move(mesher.mesh);
}

}  // namespace bempd::bem
