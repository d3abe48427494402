#pragma once

#include <vector>

namespace bempd::crack {

// R-curve: fracture energy by the length that a tip has grown, as a share of the material's fracture energy. The share
// is linear between the rows of a table and constant before the first and after the last row.
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
