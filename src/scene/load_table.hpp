#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene_values.hpp"

namespace bempd::scene {

class Scene;

// Factors of supports and loads by time: at a row's time the value of what has a column is its constant part and the
// factor times its proportional part, and between two rows it goes on a straight line. What has no column takes the
// time as its factor.
struct LoadTable {
  struct Column {
    bool is_support;
    int id;
    bool operator==(const Column&) const = default;
  };

  std::vector<double> times;    // ascending
  std::vector<Column> columns;  // none: one column, for all supports and loads
  std::vector<double> factors;  // row by row

  // Throws Error (argument) for tables that cannot be meant, and for columns of what the scene does not have.
  void check(const Scene& scene) const;

  // Values at the time of a row, of supports and loads with these.
  SceneValues at(std::size_t row, const SceneValues& given) const;

 private:
  std::size_t width() const { return columns.empty() ? 1 : columns.size(); }
};

}  // namespace bempd::scene
