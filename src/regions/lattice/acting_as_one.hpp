#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "regions/preparation.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Ids (ascending) of the regions that can be reached from `region` across common edges, and of `region` itself. Each
// common edge that is crossed has to belong to two regions for which are_one(id, id) holds.
template <class Predicate>
std::vector<int> regions_touching(int region, const Arrangement& arrangement, const Predicate& are_one) {
  const std::vector<Contact>& contacts = arrangement.contacts;
  const auto before = [](const Contact& contact, int number) { return contact.region < number; };
  std::vector<int> waiting{region};
  std::set<int> found{region};
  while (!waiting.empty()) {
    const int at = waiting.back(), number = at - 1;
    waiting.pop_back();
    auto contact = std::lower_bound(contacts.begin(), contacts.end(), number, before);
    for (; contact != contacts.end() && contact->region == number; ++contact) {
      const int other = contact->other_region + 1;
      if (are_one(at, other) && found.insert(other).second) waiting.push_back(other);
    }
  }
  return {found.begin(), found.end()};
}

// Region with an id as a region of the class `Kind`; null if it is of another class.
template <class Kind>
Kind* region_as(const Preparation& preparation, int id) {
  const auto reaches = [](const std::unique_ptr<Region>& one, int wanted) { return one->id() < wanted; };
  return dynamic_cast<Kind*>(
      std::lower_bound(preparation.regions.begin(), preparation.regions.end(), id, reaches)->get());
}

}  // namespace bempd::regions
