#include "regions/formulation.hpp"

namespace bempd::model {

Formulation Formulation::from(const Options& options) {
  Formulation f;
  f.printed_critical_stretch = options.text_value("critical_stretch") == "printed";
  f.paper = options.text_value("scheme") == "paper";
  f.grade_corners = !f.paper && options.text_value("bem.grading") == "auto";
  if (!f.paper) return f;
  f.cell_centred = options.text_value("paper.lattice") == "cell_centred";
  f.pointwise_traction = options.text_value("paper.interface") == "traction";
  if (options.text_value("paper.corner_tractions") == "one") f.corner_tractions = CornerTractions::one;
  return f;
}

}  // namespace bempd::model
