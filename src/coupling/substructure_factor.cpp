#include "coupling/substructure_factor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "cancellation.hpp"
#include "coupling/lower_blocks.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::coupling {

// Substructure (part of a matrix) and its elimination. With the index a for eliminated and b for remaining unknowns,
// A_aa = L L^T: `pivots` has L, `below` is A_ba L^-T, and `rest` is the Schur complement on b.
struct Substructure {
  // Components of the substructure: two halves, or parts of the matrix. `places` has for each component (halves first)
  // the places of its unknowns among those of the substructure.
  std::vector<std::shared_ptr<const Substructure>> halves;
  std::vector<MatrixPart> parts;
  std::vector<std::vector<int>> places;
  Eigen::Index eliminated = 0, count = 0;

  linalg::DenseCholesky pivots;
  Eigen::MatrixXd below;
  PackedLower rest;
  Eigen::VectorXd diagonal;  // diagonal of the sum of all parts, for the remaining unknowns
  double smallest_pivot_ratio = 1;

  // Last right-hand side and result of eliminate_from(); solutions of scenes with longer cracks often need both again.
  mutable Eigen::VectorXd rhs, eliminated_rhs;

  void eliminate_from(Eigen::MatrixXd& values) const;
  const void* first_component() const {
    return halves.empty() ? parts.front().source.get() : static_cast<const void*>(halves.front().get());
  }

  bool consists_of_the_same_as(const Substructure& other) const {
    return halves == other.halves && places == other.places && eliminated == other.eliminated &&
           std::equal(parts.begin(), parts.end(), other.parts.begin(), other.parts.end(),
                      [](const MatrixPart& a, const MatrixPart& b) { return a.is_made_as(b); });
  }

  bool eliminate();
};

namespace {

// Number of matrix parts (condensed operators and holding springs) up to which a substructure is not halved.
constexpr std::size_t smallest_substructure = 3;
constexpr int most_halvings = 60;  // ends the halving of parts with one centre
// Limit on the number of unknowns in changing matrix parts, over the root of the number of all unknowns, up to which
// they are joined last. The last substructure of the other parts grows with this root to about the same number.
constexpr double most_joined_last = 8;

}  // namespace

// Eliminates the unknowns of the substructure that come first; false if its matrix is not positive definite.
bool Substructure::eliminate() {
  check_cancelled();
  const Eigen::Index remaining = count - eliminated;
  LowerBlocks sum(eliminated, remaining);
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(count);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool is_half = k < halves.size();
    if (is_half) {
      sum.add(halves[k]->rest, places[k]);
      whole(places[k]) += halves[k]->diagonal;
      smallest_pivot_ratio = std::min(smallest_pivot_ratio, halves[k]->smallest_pivot_ratio);
    } else {
      const Eigen::MatrixXd& matrix = parts[k - halves.size()].entries();
      sum.add(matrix, places[k]);
      whole(places[k]) += matrix.diagonal();
    }
  }
  diagonal = whole.tail(remaining);
  below = std::move(sum.coupling);
  if (eliminated == 0) {
    rest.take(sum.remaining);
    return true;
  }
  pivots.compute(std::move(sum.eliminated));
  if (pivots.info() != Eigen::Success) return false;
  if (remaining > 0) {
    linalg::solve_upper_from_right(pivots.lower(), below);
    linalg::add_square(sum.remaining, below, -1);
    rest.take(sum.remaining);
  }
  const Eigen::VectorXd ratios = pivots.lower().diagonal().cwiseAbs2().cwiseQuotient(whole.head(eliminated));
  smallest_pivot_ratio = std::min(smallest_pivot_ratio, ratios.minCoeff());
  return smallest_pivot_ratio > linalg::singular_pivot_ratio;
}

// Forward elimination of right-hand sides (one column each), whose rows are the unknowns of the substructure.
void Substructure::eliminate_from(Eigen::MatrixXd& values) const {
  const bool is_one = values.cols() == 1;
  const auto bytes = static_cast<std::size_t>(values.size()) * sizeof(double);
  if (is_one && rhs.size() == values.size() && std::memcmp(rhs.data(), values.data(), bytes) == 0) {
    values = eliminated_rhs;
    return;
  }
  Eigen::VectorXd given;
  if (is_one) given = values;
  rhs.resize(0);  // empty until the result is stored, in case memory ends
  pivots.lower().triangularView<Eigen::Lower>().solveInPlace(values.topRows(eliminated));
  values.bottomRows(below.rows()).noalias() -= below * values.topRows(eliminated);
  if (!is_one) return;
  eliminated_rhs = values;
  rhs.swap(given);
}

// Builder that gathers parts into substructures and eliminates their unknowns.
class SubstructureFactor::Builder {
 public:
  Builder(std::vector<MatrixPart> parts, Eigen::Index unknowns, const SubstructureFactor* before)
      : parts_(std::move(parts)),
        uses_(static_cast<std::size_t>(unknowns), 0),
        uses_here_(uses_.size(), 0),
        place_(uses_.size(), -1),
        before_(before),
        made_(std::make_unique<SubstructureFactor>()) {
    for (const MatrixPart& part : parts_)
      for (const int unknown : part.unknowns) ++uses_[static_cast<std::size_t>(unknown)];
  }

  std::unique_ptr<SubstructureFactor> make(const std::array<Point, 2>& box) {
    if (parts_.empty() || std::count(uses_.begin(), uses_.end(), 0) > 0) return nullptr;
    std::vector<std::size_t> steady, changing;
    std::size_t unknowns = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      (parts_[k].changes ? changing : steady).push_back(k);
      if (parts_[k].changes) unknowns += parts_[k].unknowns.size();
    }
    if (static_cast<double>(unknowns) > most_joined_last * std::sqrt(static_cast<double>(uses_.size()))) {
      steady.resize(parts_.size());
      std::iota(steady.begin(), steady.end(), 0);
      changing.clear();
    }
    const bool is_gathered = steady.empty()     ? gather(std::move(changing), box, 0)
                             : changing.empty() ? gather(std::move(steady), box, 0)
                                                : join(std::move(steady), box, std::move(changing), box, 0);
    if (!is_gathered) return nullptr;
    made_->smallest_pivot_ratio_ = made_->steps_.back().result->smallest_pivot_ratio;
    return std::move(made_);
  }

 private:
  // Appends the elimination steps of a substructure that consists of the matrix parts `members`, after the steps of its
  // halves; false if the matrix is not positive definite.
  bool gather(std::vector<std::size_t> members, std::array<Point, 2> box, int depth) {
    if (members.size() <= smallest_substructure || depth == most_halvings) return finish({}, members);
    const int axis = (box[1] - box[0]).x() >= (box[1] - box[0]).y() ? 0 : 1;
    const double middle = 0.5 * (box[0][axis] + box[1][axis]);
    std::vector<std::size_t> lower, upper;
    for (const std::size_t k : members) (parts_[k].centre[axis] < middle ? lower : upper).push_back(k);
    std::array<Point, 2> lower_box = box, upper_box = box;
    lower_box[1][axis] = upper_box[0][axis] = middle;
    if (lower.empty()) return gather(std::move(members), upper_box, depth + 1);
    if (upper.empty()) return gather(std::move(members), lower_box, depth + 1);
    return join(std::move(lower), lower_box, std::move(upper), upper_box, depth + 1);
  }

  bool join(std::vector<std::size_t> first, const std::array<Point, 2>& first_box, std::vector<std::size_t> second,
            const std::array<Point, 2>& second_box, int depth) {
    if (!gather(std::move(first), first_box, depth)) return false;
    const std::size_t end_of_first = made_->steps_.size() - 1;
    if (!gather(std::move(second), second_box, depth)) return false;
    return finish({end_of_first, made_->steps_.size() - 1}, {});
  }

  // Makes a substructure of two halves (indices of steps) or of matrix parts, and eliminates its unknowns that occur in
  // no part outside of it. Returns false if its matrix is not positive definite or nearly singular.
  bool finish(const std::vector<std::size_t>& halves, const std::vector<std::size_t>& members) {
    std::vector<const int*> begin, end;
    Substructure found;
    for (const std::size_t half : halves) {
      const Step& step = made_->steps_[half];
      found.halves.push_back(step.result);
      begin.push_back(step.unknowns.data() + step.result->eliminated);
      end.push_back(step.unknowns.data() + step.unknowns.size());
      for (std::size_t k = 0; k < uses_of_[half].size(); ++k)
        uses_here_[static_cast<std::size_t>(begin.back()[k])] += uses_of_[half][k];
    }
    for (const std::size_t k : members) {
      found.parts.push_back(parts_[k]);
      begin.push_back(parts_[k].unknowns.data());
      end.push_back(begin.back() + parts_[k].unknowns.size());
      for (const int unknown : parts_[k].unknowns) ++uses_here_[static_cast<std::size_t>(unknown)];
    }
    Step step;
    step.unknowns = numbered(begin, end);
    found.count = static_cast<Eigen::Index>(step.unknowns.size());
    found.eliminated = eliminated_;
    for (std::size_t c = 0; c < begin.size(); ++c) {
      found.places.emplace_back();
      for (const int* u = begin[c]; u != end[c]; ++u)
        found.places.back().push_back(place_[static_cast<std::size_t>(*u)]);
    }
    uses_of_.emplace_back();
    for (std::size_t k = 0; k < step.unknowns.size(); ++k) {
      const auto unknown = static_cast<std::size_t>(step.unknowns[k]);
      if (k >= static_cast<std::size_t>(eliminated_)) uses_of_.back().push_back(uses_here_[unknown]);
      place_[unknown] = -1, uses_here_[unknown] = 0;
    }
    step.result = known_or_new(std::move(found));
    if (!step.result) return false;
    made_->steps_.push_back(std::move(step));
    return true;
  }

  // Unknowns of a substructure, the eliminated ones first. Component k of it (half or matrix part) has the unknowns
  // begin[k] .. end[k]. Sets place_ (index in the result) and eliminated_.
  std::vector<int> numbered(const std::vector<const int*>& begin, const std::vector<const int*>& end) {
    std::vector<int> order, kept;
    for (std::size_t c = 0; c < begin.size(); ++c)
      for (const int* u = begin[c]; u != end[c]; ++u) {
        const auto unknown = static_cast<std::size_t>(*u);
        if (place_[unknown] >= 0) continue;
        place_[unknown] = 0;
        (uses_here_[unknown] == uses_[unknown] ? order : kept).push_back(*u);
      }
    eliminated_ = static_cast<Eigen::Index>(order.size());
    order.insert(order.end(), kept.begin(), kept.end());
    for (std::size_t k = 0; k < order.size(); ++k) place_[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    return order;
  }

  std::shared_ptr<const Substructure> known_or_new(Substructure found) {
    std::shared_ptr<const Substructure> result = known(found, *made_);
    if (!result && before_) result = known(found, *before_);
    if (result) {
      ++made_->taken_over_;
    } else {
      auto own = std::make_shared<Substructure>(std::move(found));
      if (!own->eliminate()) return nullptr;
      for (MatrixPart& part : own->parts) part.matrix = nullptr;
      result = std::move(own);
    }
    made_->known_.emplace(result->first_component(), result);
    return result;
  }

  static std::shared_ptr<const Substructure> known(const Substructure& wanted, const SubstructureFactor& factor) {
    const auto [first, last] = factor.known_.equal_range(wanted.first_component());
    const auto same =
        std::find_if(first, last, [&](const auto& one) { return one.second->consists_of_the_same_as(wanted); });
    return same == last ? nullptr : same->second;
  }

  std::vector<MatrixPart> parts_;
  std::vector<int> uses_, uses_here_, place_;  // per unknown: parts with it, in all and here; its place
  std::vector<std::vector<int>> uses_of_;      // per step: number of parts with each remaining unknown
  const SubstructureFactor* before_;
  std::unique_ptr<SubstructureFactor> made_;
  Eigen::Index eliminated_ = 0;
};

std::unique_ptr<SubstructureFactor> SubstructureFactor::of(std::vector<MatrixPart> parts,
                                                           const std::array<Point, 2>& box, Eigen::Index unknowns,
                                                           const SubstructureFactor* before) {
  return Builder(std::move(parts), unknowns, before).make(box);
}

void SubstructureFactor::solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const {
  Eigen::MatrixXd values;
  const auto take = [&](const std::vector<int>& unknowns) {
    values.resize(static_cast<Eigen::Index>(unknowns.size()), rhs.cols());
    for (Eigen::Index k = 0; k < values.rows(); ++k) values.row(k) = rhs.row(unknowns[static_cast<std::size_t>(k)]);
  };
  const auto put = [&](const std::vector<int>& unknowns) {
    for (Eigen::Index k = 0; k < values.rows(); ++k) rhs.row(unknowns[static_cast<std::size_t>(k)]) = values.row(k);
  };
  for (const Step& step : steps_) {
    const Substructure& s = *step.result;
    if (s.eliminated == 0) continue;
    take(step.unknowns);
    s.eliminate_from(values);
    put(step.unknowns);
  }
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    const Substructure& s = *step->result;
    if (s.eliminated == 0) continue;
    take(step->unknowns);
    values.topRows(s.eliminated).noalias() -= s.below.transpose() * values.bottomRows(s.below.rows());
    s.pivots.lower().triangularView<Eigen::Lower>().transpose().solveInPlace(values.topRows(s.eliminated));
    put(step->unknowns);
  }
}

std::int64_t SubstructureFactor::factor_nonzeros() const {
  std::int64_t count = 0;
  for (const Step& step : steps_) {
    const Substructure& s = *step.result;
    count += s.eliminated * (s.eliminated + 1) / 2 + s.below.size();
  }
  return count;
}

}  // namespace bempd::coupling
