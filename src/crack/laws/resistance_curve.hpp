#pragma once

#include <vector>

namespace bempd::crack {

// Fracture energy that changes with the growth of a tip (R-curve), in shares of the material's fracture energy. It is
// linear between the rows of a table and constant before the first and behind the last one.
class ResistanceCurve {
 public:
  // `extensions`: lengths by which a tip has grown, >= 0 and ascending [m]; `shares` > 0.
  ResistanceCurve(std::vector<double> extensions, std::vector<double> shares);

  double share(double grown) const;
  bool operator==(const ResistanceCurve&) const = default;
  const std::vector<double>& extensions() const { return extensions_; }
  const std::vector<double>& shares() const { return shares_; }

 private:
  std::vector<double> extensions_, shares_;
};

}  // namespace bempd::crack
