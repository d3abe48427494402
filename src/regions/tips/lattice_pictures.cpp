#include "regions/tips/lattice_pictures.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace bempd::regions {

namespace {

// Length of the shortest bond at each node, about one spacing; a diagonal bond of a cell is 1.4 times as long.
std::vector<double> spacings(const BondedBody& body) {
  std::vector<double> found(body.discretization.positions.size(), std::numeric_limits<double>::infinity());
  for (std::size_t b = 0; b < body.bonds.size(); ++b) {
    if (body.bonds.is_wide(b)) continue;
    for (const int node : {body.bonds.first[b], body.bonds.second[b]})
      found[node] = std::min(found[node], body.bonds.length[b]);
  }
  return found;
}

}  // namespace

std::vector<CrackPicture> lattice_crack_pictures(const BondedBody& body, const Eigen::VectorXd& displacement,
                                                 const std::function<int(const Point&)>& nearest_crack) {
  const std::vector<double> spacing = spacings(body);
  std::map<int, CrackPicture> pictures;
  for (std::size_t b = 0; b < body.bonds.size(); ++b) {
    if (body.intact[b] || body.bonds.is_wide(b)) continue;
    const int low = body.bonds.first[b], high = body.bonds.second[b];
    const double length = body.bonds.length[b];
    if (length > 1.3 * std::max(spacing[low], spacing[high])) continue;
    const Point middle = 0.5 * (body.discretization.positions[low] + body.discretization.positions[high]);
    // The segment of the picture crosses the bond at the bond's middle, and the bond's second point lies on the left of
    // the segment.
    const Point half = 0.5 * length * Point(body.bonds.sine[b], -body.bonds.cosine[b]);
    const Point of_low = displacement.segment<2>(2 * low), of_high = displacement.segment<2>(2 * high);
    const int crack = nearest_crack(middle);
    CrackPicture& picture = pictures.try_emplace(crack, CrackPicture{crack, {}, {}, {}}).first->second;
    picture.places.insert(picture.places.end(), {middle - half, middle, middle + half});
    picture.openings.insert(picture.openings.end(), 3, of_high - of_low);
    picture.displacements.insert(picture.displacements.end(), 3, 0.5 * (of_low + of_high));
  }
  std::vector<CrackPicture> all;
  all.reserve(pictures.size());
  for (auto& [crack, picture] : pictures) all.push_back(std::move(picture));
  return all;
}

}  // namespace bempd::regions
