#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene_values.hpp"

namespace bempd::scene {

class Scene;

// Load program: a table of factors of supports and loads by time. At the time of a row, the value of a support or load
// with a column is its constant part plus the factor times its proportional part. Between two rows it is linear in
// time. A support or load without a column takes the time as its factor.
struct LoadTable {
  struct Column {
    bool is_support;
    int id;
    bool operator==(const Column&) const = default;
  };

  std::vector<double> times;    // ascending
  std::vector<Column> columns;  // empty: one column of factors, for all supports and loads
  std::vector<double> factors;  // row by row

  // Throws Error (argument) if times do not increase, a number is not finite, or the scene does not have the support or
  // load of a column.
  void check(const Scene& scene) const;

  // Values of all supports and loads at the time of a row; `given` are the values that the host gave them.
  SceneValues at(std::size_t row, const SceneValues& given) const;

 private:
  std::size_t width() const { return columns.empty() ? 1 : columns.size(); }
};

}  // namespace bempd::scene
