#include "bem/crack_mesh.hpp"

#include <cassert>
#include <cmath>

#include "error.hpp"

namespace bempd::bem {

namespace {

struct Mouth {
  int before = -1, after = -1;  // boundary nodes
};

// The node before a mouth keeps its number.
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

// A member of a joint: an opening with its sign, positive if the line starts there.
struct Member {
  int node;
  double sign;
};

class Mesher {
 public:
  Mesher(const CrackLines& cracks, BoundaryMesh& boundary, double tolerance)
      : cracks_(cracks), members_(cracks.joints.size()), mouths_(cracks.joints.size()) {
    for (std::size_t j = 0; j < cracks.joints.size(); ++j) {
      places_.push_back(cracks.joints[j].place);
      mesh.mouth_of_joint.push_back({-1, -1});
      if (!cracks.joints[j].mouth) continue;
      mouths_[j] = split_at(places_[j], boundary, tolerance);
      mesh.mouth_of_joint[j] = {mouths_[j].before, mouths_[j].after};
      places_[j] = boundary.nodes[mouths_[j].before];
    }
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
      // Quarter points: the mid node of a tip element is close to the tip.
      const double middle = tip == TipEnd::start ? 0.25 : tip == TipEnd::end ? 0.75 : 0.5;
      mesh.nodes.push_back(start + middle * (end - start));
      mesh.nodes.push_back(end);
      mesh.elements.push_back({{node, node + 1, node + 2}, l, stations[e], stations[e + 1], tip});
      if (tip != TipEnd::none) add_tip(l, tip, start, end);
    }
    mesh.joint_of_node.resize(mesh.nodes.size(), -1);
    add_end(line.joints[0], first, 1);
    add_end(line.joints[1], first + 2 * count, -1);
  }

  void constrain(int boundary_nodes) {
    const int raw = static_cast<int>(mesh.nodes.size());
    std::vector<int> column(raw, -1);
    std::vector<char> removed(raw, 0);
    for (const CrackTip& tip : mesh.tips) {
      const CrackElement& element = mesh.elements[tip.element];
      removed[element.nodes[tip.end == TipEnd::start ? 0 : 2]] = 1;
    }
    for (const auto& members : members_)
      if (!members.empty()) removed[members.back().node] = 1;
    for (int n = 0; n < raw; ++n)
      if (!removed[n]) column[n] = boundary_nodes + mesh.free_nodes++;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int node, int from, double factor) {
      for (int c = 0; c < 2; ++c) entries.emplace_back(2 * node + c, 2 * from + c, factor);
    };
    for (int n = 0; n < raw; ++n)
      if (!removed[n]) add(n, column[n], 1);
    for (std::size_t j = 0; j < members_.size(); ++j) {
      if (members_[j].empty()) continue;
      const Member last = members_[j].back();
      for (std::size_t m = 0; m + 1 < members_[j].size(); ++m)
        add(last.node, column[members_[j][m].node], -last.sign * members_[j][m].sign);
      if (mouths_[j].before < 0) continue;
      add(last.node, mouths_[j].before, last.sign);
      add(last.node, mouths_[j].after, -last.sign);
    }
    mesh.constraint.resize(2 * raw, 2 * (boundary_nodes + mesh.free_nodes));
    mesh.constraint.setFromTriplets(entries.begin(), entries.end());
  }

  CrackMesh mesh;

 private:
  // On the line; its ends are the places of its joints.
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

  void add_tip(int line, TipEnd end, const Point& from, const Point& to) {
    const Point along = (to - from).normalized();
    const int element = static_cast<int>(mesh.elements.size()) - 1;
    mesh.tips.push_back(end == TipEnd::start ? CrackTip{element, line, end, from, -along}
                                             : CrackTip{element, line, end, to, along});
  }

  void add_end(int joint, int node, double sign) {
    if (joint < 0) return;
    members_[joint].push_back({node, sign});
    mesh.joint_of_node[node] = joint;
  }

  const CrackLines& cracks_;
  std::vector<std::vector<Member>> members_;
  std::vector<Mouth> mouths_;
  std::vector<Point> places_;
};

}  // namespace

CrackMesh mesh_cracks(const CrackLines& cracks, const std::vector<std::vector<double>>& stations,
                      BoundaryMesh& boundary, double tolerance) {
  Mesher mesher(cracks, boundary, tolerance);
  for (int l = 0; l < static_cast<int>(cracks.lines.size()); ++l) mesher.add_line(l, stations[l]);
  mesher.constrain(static_cast<int>(boundary.nodes.size()));
  return std::move(mesher.mesh);
}

}  // namespace bempd::bem
