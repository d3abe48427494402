#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_path.hpp"
#include "fracture/line/tip_fields.hpp"

namespace bempd::fracture {

// Guard around the tips of crack lines (cracks that grow in a lattice by steps): terms (bonds and cell squares) near a
// tip do not break by themselves.
class LineGuard {
 public:
  LineGuard(LoadedBody& body, const TipFields& fields, const LinePath& path)
      : body_(body), fields_(fields), path_(path) {}

  // Whether a term is too close to a tip to break by itself.
  bool is_guarded(int term, const GrowingTip& tip) const;
  // Marks terms (bonds and cell squares) near a tip as not intact in `intact`, because they do not break by themselves.
  // Without `overloaded_at` these are all terms near the tip, with it only terms overloaded at that load factor.
  void exempt(const GrowingTip& tip, std::vector<char>& intact, std::optional<double> overloaded_at = {}) const;

 private:
  LoadedBody& body_;
  const TipFields& fields_;
  const LinePath& path_;
};

}  // namespace bempd::fracture
