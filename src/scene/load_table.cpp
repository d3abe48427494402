#include "scene/load_table.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "scene/moved_values.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

void LoadTable::check(const Scene& scene) const {
  for (std::size_t row = 0; row < times.size(); ++row) {
    require(std::isfinite(times[row]), "time ", row + 1, " is ", times[row], "; it must be a finite number");
    require(row == 0 || times[row] > times[row - 1], "time ", row + 1, " is ", times[row], " and the one before it ",
            row > 0 ? times[row - 1] : 0, "; give times that increase");
  }
  for (std::size_t i = 0; i < factors.size(); ++i)
    require(std::isfinite(factors[i]), "the factor of row ", i / width() + 1, ", column ", i % width() + 1, " is ",
            factors[i], "; it must be a finite number");
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto [is_support, id] = columns[c];
    const auto& conditions = is_support ? scene.supports() : scene.loads();
    const char* what = is_support ? "support " : "load ";
    require(id >= 1 && id <= static_cast<int>(conditions.size()), "column ", c + 1, " is of ", what, id,
            ", which does not exist; there are ", conditions.size());
    const Condition& condition = conditions[static_cast<std::size_t>(id - 1)];
    require(!condition.removed(), "column ", c + 1, " is of ", what, id, ", which was removed");
    const bool is_second = std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(c), columns[c]) !=
                           columns.begin() + static_cast<std::ptrdiff_t>(c);
    require(!is_second, "column ", c + 1, " is of ", what, id, ", which has a column before; give it one");
  }
}

SceneValues LoadTable::at(std::size_t row, const SceneValues& given) const {
  SceneValues result = fixed_at(given, columns.empty() ? factors[row] : times[row]);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto place = static_cast<std::size_t>(columns[c].id - 1);
    const Values& value = columns[c].is_support ? given.supports[place] : given.loads[place];
    (columns[c].is_support ? result.supports[place] : result.loads[place]) =
        fixed_at(value, factors[row * width() + c]);
  }
  return result;
}

}  // namespace bempd::scene
