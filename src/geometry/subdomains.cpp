#include "geometry/subdomains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/cut_body.hpp"
#include "geometry/edge.hpp"
#include "geometry/material_cut.hpp"
#include "geometry/placed_nodes.hpp"

namespace bempd {

namespace {

// Largest number of elements of a part after a cut, relative to the number before the cut.
constexpr double largest_share = 0.85;
// Limit on the elements of subdomains that cracks have changed, as a multiple of the limit for other subdomains. They
// are cut less, because cuts beside cracks would cost accuracy.
constexpr std::size_t largest_beside_cracks = 2;

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
    divide({loops_of(body_)});
    return finished();
  }

  Subdivision run(const std::vector<Stations>& cuts, const std::vector<Stations>& cracks,
                  std::shared_ptr<const CutBody> before) {
    cracks_ = cracks;
    std::vector<char> made(cuts.size());
    for (std::size_t c = 0; c < cuts.size(); ++c) made[c] = is_clear_of(cuts[c], cracks_) ? 1 : 0;
    done_.joined = before && before->is_of(body_, cuts, made) ? std::move(before) : cut_along(cuts, std::move(made));
    positions_ = done_.joined->positions, panels_ = done_.joined->panels;
    done_.cuts = done_.joined->made, left_out_ = done_.joined->left_out;
    divide(done_.joined->parts);
    return finished();
  }

 private:
  // Cuts the body along the cuts with the flag `made`, except cuts that would have the same part on both sides.
  std::shared_ptr<const CutBody> cut_along(const std::vector<Stations>& cuts, std::vector<char> made) {
    auto cut = std::make_shared<CutBody>();
    cut->body = body_, cut->given = cuts, cut->keep_off = made;
    do cut->parts = split(loops_of(body_), cuts_made(cuts, made), positions_);
    while (drop_slits(cut->parts, made));
    if (cut->parts.empty()) {
      cuts_made({}, {});
      cut->parts = {loops_of(body_)};
    }
    cut->positions = positions_, cut->panels = panels_;
    cut->made = done_.cuts, cut->left_out = left_out_;
    return cut;
  }

  // Halves parts that have too many elements; in a body with cracks, only parts that the cracks have changed.
  void divide(std::vector<SubdomainLoops> waiting) {
    while (!waiting.empty()) {
      SubdomainLoops loops = std::move(waiting.back());
      waiting.pop_back();
      std::vector<int> cracks = cracks_in(loops);
      std::vector<SubdomainLoops> parts;
      const bool is_changed = !cracks.empty() || misses_cut(loops);
      if (count_of(loops) > (is_changed ? largest_beside_cracks * most_ : most_) && (cracks_.empty() || is_changed))
        parts = halves(loops, cracks);
      if (parts.empty()) {
        done_.subdomains.push_back(subdomain(loops));
        done_.subdomains.back().cracks = std::move(cracks);
      } else {
        std::move(parts.begin(), parts.end(), std::back_inserter(waiting));
      }
    }
  }

  Subdivision finished() {
    done_.cut_nodes.assign(positions_.begin() + static_cast<std::ptrdiff_t>(body_.nodes.size()), positions_.end());
    return std::move(done_);
  }

  std::vector<int> cracks_in(const SubdomainLoops& loops) const {
    std::vector<int> found;
    if (cracks_.empty()) return found;
    Box box;
    for (const SubdomainSide& side : loops.front()) box.extend(positions_[side.nodes[0]]);
    for (std::size_t c = 0; c < cracks_.size(); ++c) {
      const std::size_t middle = cracks_[c].size() / 2;
      const Point place = 0.5 * (cracks_[c][middle - 1] + cracks_[c][middle]);
      if (!box.contains(place)) continue;
      std::size_t around = 0;
      for (const SubdomainLoop& loop : loops) around += encloses(loop, place, positions_) ? 1 : 0;
      if (around == 1) found.push_back(static_cast<int>(c));
    }
    return found;
  }

  // Whether a cut that was not made ends at a node of the subdomain.
  bool misses_cut(const SubdomainLoops& loops) const {
    for (const SubdomainLoop& loop : loops)
      for (const SubdomainSide& side : loop)
        if (left_out_.count(side.nodes[0]) > 0) return true;
    return false;
  }

  // Makes the cuts that have the flag `made` and end at nodes of the body or of earlier cuts; returns their sides.
  std::vector<SubdomainLoop> cuts_made(const std::vector<Stations>& cuts, const std::vector<char>& made) {
    positions_.resize(body_.nodes.size());
    left_out_.clear();
    done_.cuts.clear();
    cut_of_panel_.clear();
    PlacedNodes ends(body_);
    std::vector<SubdomainLoop> rows;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      const int from = ends.at(cuts[c].front()), to = ends.at(cuts[c].back());
      if (from < 0 || to < 0 || !made[c]) {
        if (from >= 0) left_out_.insert(from);
        if (to >= 0) left_out_.insert(to);
        continue;
      }
      cut_of_panel_[panels_] = c;
      rows.push_back(elements_on({from, to, cuts[c]}));
      for (const SubdomainSide& side : rows.back())
        if (side.nodes[2] != to) ends.add(positions_[side.nodes[2]], side.nodes[2]);
    }
    return rows;
  }

  // Clears the flags `made` of cuts that have the same part on both sides; returns whether there are such cuts.
  bool drop_slits(const std::vector<SubdomainLoops>& parts, std::vector<char>& made) const {
    bool found = false;
    for (const SubdomainLoops& part : parts)
      for (const int panel : slits_in(part)) {
        made[cut_of_panel_.at(panel)] = 0;
        found = true;
      }
    return found;
  }

  // Panels of the cuts that have this part on both sides.
  static std::set<int> slits_in(const SubdomainLoops& part) {
    std::set<int> slits, middles;
    for (const SubdomainLoop& loop : part)
      for (const SubdomainSide& side : loop)
        if (side.element < 0 && !middles.insert(side.nodes[1]).second) slits.insert(side.panel);
    return slits;
  }

  // The two parts into which a straight cut divides a subdomain that contains the given cracks; empty if there is no
  // such cut.
  std::vector<SubdomainLoops> halves(const SubdomainLoops& loops, const std::vector<int>& cracks) {
    std::vector<Stations> own;
    for (const int crack : cracks) own.push_back(cracks_[static_cast<std::size_t>(crack)]);
    const MaterialCutSearch search(loops, positions_, own);
    for (const int axis : {search.longer_axis(), 1 - search.longer_axis()}) {
      const auto division = search.along(axis);
      if (!division) continue;
      const std::size_t nodes = positions_.size(), made = done_.cuts.size();
      std::vector<SubdomainLoop> cuts;
      for (const MaterialCut& cut : division->cuts) cuts.push_back(elements_on(cut));
      std::vector<SubdomainLoops> parts = split(loops, cuts, positions_);
      const auto serves = [&](const SubdomainLoops& part) {
        return static_cast<double>(count_of(part)) <= largest_share * static_cast<double>(count_of(loops)) &&
               slits_in(part).empty();
      };
      if (!parts.empty() && std::all_of(parts.begin(), parts.end(), serves)) return parts;
      positions_.resize(nodes);
      done_.cuts.resize(made);
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
    done_.cuts.push_back(cut.stations);
    ++panels_;
    return sides;
  }

  // Rotates the order of a loop so that it begins at the leftmost (and then lowest) start of a panel. Subdomains that
  // differ by a translation are then numbered alike.
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
  std::vector<Point> positions_;  // positions of the body's nodes, then of nodes on cuts
  std::size_t most_;
  int panels_ = 0;  // number of panels, with one for each cut
  std::vector<Stations> cracks_;
  std::set<int> left_out_;  // nodes at the ends of cuts that were not made
  std::map<int, std::size_t> cut_of_panel_;
  Subdivision done_;
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

Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements, const std::vector<Stations>& cuts,
                      const std::vector<Stations>& cracks, const Subdivision* before) {
  return Subdivider(body, most_elements).run(cuts, cracks, before ? before->joined : nullptr);
}

}  // namespace bempd
