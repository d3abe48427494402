#include "regions/lattice/tied_points.hpp"

#include <utility>

#include "coupling/interface_trace.hpp"
#include "error.hpp"

namespace bempd::regions {

void tie(const PointRow& row, const LeadingElements& leading, int leader, coupling::NodeTies& ties) {
  const Point &start = leading.places.front(), &end = leading.places.back();
  // A row of elements that ends at the mouth of a crack reaches half a spacing beyond the last material point.
  const bool starts_at_point = (row.places.front() - start).norm() < 0.25 * row.point_distance;
  const bool ends_at_point = (row.places.back() - end).norm() < 0.25 * row.point_distance;
  std::vector<double> stations;
  for (std::size_t a = 0; a < leading.places.size(); a += 2)
    stations.push_back((leading.places[a] - start).norm() / row.point_distance - (starts_at_point ? 0 : 0.5));
  stations.back() = static_cast<double>(row.places.size() - 1) + (ends_at_point ? 0 : 0.5);
  const auto trace = coupling::interface_trace(stations);
  require(trace.has_value(), "edge ", leading.edge, " of region ", leader,
          " has elements of its own on the interface with region ", row.region, ", from (", start.x(), ", ", start.y(),
          ") to (", end.x(), ", ", end.y(), "), that cannot be joined to its ", row.places.size(),
          " material points; leave out bempd_set_edge_mesh() for this edge, so "
          "that its elements follow them");
  for (std::size_t i = starts_at_point ? 1 : 0; i + (ends_at_point ? 1 : 0) < row.places.size(); ++i) {
    std::vector<coupling::NodeTies::Master> masters;
    using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    for (Row it(*trace, static_cast<Eigen::Index>(i)); it; ++it)
      masters.push_back({leading.nodes[static_cast<std::size_t>(it.col())], it.value()});
    ties.add(row.nodes[i], std::move(masters));
  }
}

}  // namespace bempd::regions
