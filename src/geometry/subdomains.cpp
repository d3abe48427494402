#include "geometry/subdomains.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/material_cut.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

namespace {

// A cut counts only if no part keeps a larger share of the elements.
constexpr double largest_share = 0.85;

std::size_t count_of(const SubdomainLoops& loops) {
  std::size_t count = 0;
  for (const SubdomainLoop& loop : loops) count += loop.size();
  return count;
}

SubdomainLoops loops_of(const BoundaryMesh& body) {
  SubdomainLoops loops;
  int first = -1;
  for (std::size_t e = 0; e < body.elements.size(); ++e) {
    const BoundaryElement& element = body.elements[e];
    if (first < 0) {
      first = element.nodes[0];
      loops.emplace_back();
    }
    loops.back().push_back({element.nodes, element.sweep, element.panel, static_cast<int>(e)});
    if (element.nodes[2] == first) first = -1;
  }
  return loops;
}

class Subdivider {
 public:
  Subdivider(const BoundaryMesh& body, std::size_t most) : body_(body), positions_(body.nodes), most_(most) {
    for (const BoundaryElement& element : body.elements) panels_ = std::max(panels_, element.panel + 1);
  }

  Subdivision run() {
    std::vector<SubdomainLoops> waiting{loops_of(body_)};
    Subdivision done;
    while (!waiting.empty()) {
      const SubdomainLoops loops = std::move(waiting.back());
      waiting.pop_back();
      std::vector<SubdomainLoops> parts;
      if (count_of(loops) > most_) parts = halves(loops);
      if (parts.empty()) {
        done.subdomains.push_back(subdomain(loops));
      } else {
        std::move(parts.begin(), parts.end(), std::back_inserter(waiting));
      }
    }
    done.cut_nodes.assign(positions_.begin() + static_cast<std::ptrdiff_t>(body_.nodes.size()), positions_.end());
    return done;
  }

 private:
  // Parts of a subdomain; empty if it cannot be cut.
  std::vector<SubdomainLoops> halves(const SubdomainLoops& loops) {
    const MaterialCutSearch search(loops, positions_);
    for (const int axis : {search.longer_axis(), 1 - search.longer_axis()}) {
      const auto division = search.along(axis);
      if (!division) continue;
      const std::size_t nodes = positions_.size();
      std::vector<SubdomainLoop> cuts;
      for (const MaterialCut& cut : division->cuts) cuts.push_back(elements_on(cut));
      std::vector<SubdomainLoops> parts = split(loops, cuts, positions_);
      const auto is_small = [&](const SubdomainLoops& part) {
        return static_cast<double>(count_of(part)) <= largest_share * static_cast<double>(count_of(loops));
      };
      if (std::all_of(parts.begin(), parts.end(), is_small)) return parts;
      positions_.resize(nodes);
    }
    return {};
  }

  SubdomainLoop elements_on(const MaterialCut& cut) {
    SubdomainLoop sides;
    int from = cut.from;
    for (std::size_t i = 1; i < cut.stations.size(); ++i) {
      const int middle = static_cast<int>(positions_.size());
      const bool is_last = i + 1 == cut.stations.size();
      positions_.push_back(0.5 * (cut.stations[i - 1] + cut.stations[i]));
      if (!is_last) positions_.push_back(cut.stations[i]);
      const int to = is_last ? cut.to : middle + 1;
      sides.push_back({{from, middle, to}, 0, panels_, -1});
      from = to;
    }
    ++panels_;
    return sides;
  }

  // Turns a loop so that it begins at its leftmost, then lowest, start of a panel. Subdomains that differ by a
  // translation are then numbered alike.
  void turn(SubdomainLoop& loop, double tolerance) const {
    std::size_t best = loop.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].panel == loop[(i + loop.size() - 1) % loop.size()].panel) continue;
      if (best == loop.size() || comes_before(loop[i], loop[best], tolerance)) best = i;
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best % loop.size()), loop.end());
  }

  bool comes_before(const SubdomainSide& a, const SubdomainSide& b, double tolerance) const {
    const Point way = positions_[a.nodes[0]] - positions_[b.nodes[0]];
    return std::abs(way.x()) > tolerance ? way.x() < 0 : way.y() < -tolerance;
  }

  Subdomain subdomain(SubdomainLoops loops) const {
    Point low = positions_[loops[0][0].nodes[0]], high = low;
    for (const SubdomainSide& side : loops[0]) {
      low = low.cwiseMin(positions_[side.nodes[0]]);
      high = high.cwiseMax(positions_[side.nodes[0]]);
    }
    const double tolerance = 1e-9 * (high - low).norm();
    for (SubdomainLoop& loop : loops) turn(loop, tolerance);
    std::sort(loops.begin() + 1, loops.end(), [&](const SubdomainLoop& a, const SubdomainLoop& b) {
      return comes_before(a.front(), b.front(), tolerance);
    });
    Subdomain part;
    int panel = -1;
    for (const SubdomainLoop& loop : loops) append(loop, panel, part);
    return part;
  }

  void append(const SubdomainLoop& loop, int& panel, Subdomain& part) const {
    const int first = static_cast<int>(part.nodes.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      const SubdomainSide& side = loop[i];
      const bool goes_on = i > 0 && loop[i - 1].panel == side.panel;
      if (!goes_on) {
        ++panel;
        ++part.mesh.traction_node_count;
      }
      const int node = static_cast<int>(part.nodes.size()), traction = part.mesh.traction_node_count - 1;
      for (const int k : {0, 1}) {
        part.nodes.push_back(side.nodes[k]);
        part.mesh.nodes.push_back(positions_[side.nodes[k]]);
      }
      part.mesh.elements.push_back({{node, node + 1, i + 1 == count ? first : node + 2},
                                    {traction, traction + 1, traction + 2},
                                    panel,
                                    side.sweep});
      part.mesh.traction_node_count += 2;
      part.elements.push_back(side.element);
    }
  }

  const BoundaryMesh& body_;
  std::vector<Point> positions_;  // of the body's nodes and those on cuts
  std::size_t most_;
  int panels_ = 0;  // numbers in use
};

}  // namespace

std::size_t Subdivision::largest() const {
  std::size_t most = 0;
  for (const Subdomain& part : subdomains) most = std::max(most, part.mesh.elements.size());
  return most;
}

Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements) {
  return Subdivider(body, most_elements).run();
}

}  // namespace bempd
