#include "regions/outlined/joined_outline.hpp"

#include <algorithm>
#include <utility>

namespace bempd::regions {

namespace {

constexpr int no_part = -1;

// Parts of edges around several regions that are one body, and their order along the loops.
class JoinedBorder {
 public:
  JoinedBorder(const std::vector<int>& regions, const Preparation& preparation) : preparation_(preparation) {
    for (const int id : regions) {
      const Outline& outline = preparation.scene.region(id).outline();
      int number = 0;
      for (const auto& loop : outline.loops) {
        const auto first = static_cast<int>(parts_.size());
        for (std::size_t k = 0; k < loop.size(); ++k) add_free_parts(id, ++number, regions);
        for (int p = first; p < static_cast<int>(parts_.size()); ++p) {
          const int next = p + 1 < static_cast<int>(parts_.size()) ? p + 1 : first;
          const bool follows = parts_[p].to == 1 && parts_[next].from == 0 &&
                               (parts_[next].edge - parts_[p].edge - 1) % static_cast<int>(loop.size()) == 0;
          next_.push_back(follows ? next : no_part);
        }
      }
    }
  }

  // Finds for each part that ends at a common edge the part that begins at the same place. Returns false if no part or
  // several parts begin there.
  bool join_ends() {
    std::vector<char> has_before(parts_.size(), 0);
    for (const int next : next_)
      if (next != no_part) has_before[next] = 1;
    std::vector<int> starts;
    for (int p = 0; p < static_cast<int>(parts_.size()); ++p)
      if (!has_before[p]) starts.push_back(p);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (next_[p] != no_part) continue;
      const Point end = place(parts_[p], parts_[p].to);
      const auto is_here = [&](int start) {
        return (place(parts_[start], parts_[start].from) - end).norm() <= 10 * preparation_.tolerance;
      };
      if (std::count_if(starts.begin(), starts.end(), is_here) != 1) return false;
      const auto start = std::find_if(starts.begin(), starts.end(), is_here);
      next_[p] = *start;
      starts.erase(start);
    }
    return true;
  }

  std::vector<std::vector<BorderPart>> loops() const {
    std::vector<std::vector<BorderPart>> found;
    std::vector<char> taken(parts_.size(), 0);
    for (int first = 0; first < static_cast<int>(parts_.size()); ++first) {
      if (taken[first]) continue;
      found.emplace_back();
      for (int p = first; !taken[p]; p = next_[p]) found.back().push_back(parts_[p]), taken[p] = 1;
    }
    return found;
  }

 private:
  void add_free_parts(int region, int edge, const std::vector<int>& regions) {
    const auto& contacts = preparation_.arrangement.contacts;
    const std::pair here(region - 1, edge - 1);
    auto contact = std::lower_bound(contacts.begin(), contacts.end(), here, [](const Contact& c, const auto& wanted) {
      return std::pair(c.region, c.edge) < wanted;
    });
    double from = 0;
    for (; contact != contacts.end() && std::pair(contact->region, contact->edge) == here; ++contact) {
      if (!std::binary_search(regions.begin(), regions.end(), contact->other_region + 1)) continue;
      if (contact->from > from) parts_.push_back({region, edge, from, contact->from});
      from = contact->to;
    }
    if (from < 1) parts_.push_back({region, edge, from, 1});
  }
  Point place(const BorderPart& part, double fraction) const {
    return preparation_.scene.region(part.region).edge(part.edge).at(fraction);
  }

  const Preparation& preparation_;
  std::vector<BorderPart> parts_;
  std::vector<int> next_;  // number of the part behind each part in its loop, or no_part
};

}  // namespace

std::vector<std::vector<BorderPart>> loops_around(const std::vector<int>& regions, const Preparation& preparation) {
  JoinedBorder border(regions, preparation);
  if (!border.join_ends()) return {};
  return border.loops();
}

}  // namespace bempd::regions
