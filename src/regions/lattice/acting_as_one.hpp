#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "regions/preparation.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Regions of the class `Kind` that form one lattice with a region: those that touch the region, directly or through
// other such regions, and the region itself; by ascending id.
template <class Kind>
std::vector<Kind*> touching_that_act_as_one(Kind& region, const Preparation& preparation) {
  const auto& contacts = preparation.arrangement.contacts;
  const auto region_of = [&](int id) {
    const auto reaches = [](const std::unique_ptr<Region>& one, int wanted) { return one->id() < wanted; };
    return std::lower_bound(preparation.regions.begin(), preparation.regions.end(), id, reaches)->get();
  };
  std::vector<Kind*> found{&region};
  std::set<int> ids{region.id()};
  const auto before = [](const Contact& contact, int number) { return contact.region < number; };
  for (std::size_t k = 0; k < found.size(); ++k) {
    Kind& at = *found[k];
    const int number = at.id() - 1;
    auto contact = std::lower_bound(contacts.begin(), contacts.end(), number, before);
    for (; contact != contacts.end() && contact->region == number; ++contact) {
      auto* other = dynamic_cast<Kind*>(region_of(contact->other_region + 1));
      if (other && at.acts_as_one_with(*other) && ids.insert(other->id()).second) found.push_back(other);
    }
  }
  std::sort(found.begin(), found.end(), [](const auto* a, const auto* b) { return a->id() < b->id(); });
  return found;
}

}  // namespace bempd::regions
