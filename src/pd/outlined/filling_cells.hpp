#pragma once

#include <array>
#include <vector>

#include "pd/outlined/outlined_points.hpp"

namespace bempd::pd {

// Cells that fill the polygon of the chords: whole lattice cells and, between these and the outline, triangles of
// points. Corners are counter-clockwise; a triangle has its last corner twice.
using FillingCells = std::vector<std::array<int, 4>>;

FillingCells fill_with_cells(const Chords& chords, const OutlinedPoints& points);

inline bool is_triangle(const std::array<int, 4>& cell) { return cell[2] == cell[3]; }

// Area of a cell that belongs to each of its corners.
double area_of_corner(const std::vector<Point>& points, const std::array<int, 4>& cell);

// Area that belongs to every point: a third of each triangle and a quarter of each lattice cell around it.
std::vector<double> areas_of_points(const std::vector<Point>& points, const FillingCells& cells);

}  // namespace bempd::pd
