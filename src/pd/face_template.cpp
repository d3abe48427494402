#include "pd/face_template.hpp"

#include <cassert>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "linalg/least_change.hpp"

namespace bempd::pd {

namespace {

// Stiffness of a bond in a medium that is the same everywhere along its face: the unknown with the number `index`, or
// the value `known` if `index` is -1.
struct Entry {
  int index = -1;
  double known = 0;
};

// Linear equations for the unknown stiffnesses of a medium that is the same everywhere along its face.
class Equations {
 public:
  explicit Equations(int unknowns) : unknowns_(unknowns) {}

  void begin(double target) {
    rows_.emplace_back(Eigen::VectorXd::Zero(unknowns_));
    targets_.push_back(target);
  }
  void add(double coefficient, const Entry& stiffness) {
    if (stiffness.index >= 0) rows_.back()[stiffness.index] += coefficient;
    targets_.back() -= coefficient * stiffness.known;
  }

  // Solves the equations by the least change of the stiffnesses `bulk`, none of which falls below the share `lower` of
  // its bulk value. Every equation is scaled first, because differences between the sizes of the equations mean
  // nothing.
  linalg::LeastChangeResult solve(const Eigen::VectorXd& bulk, double lower) {
    linalg::LeastChange problem;
    problem.start = problem.scale = bulk;
    problem.lower = lower;
    problem.target = Eigen::VectorXd(targets_.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const double size = std::max(rows_[r].cwiseProduct(bulk).norm(), 1e-300);
      problem.target[r] = targets_[r] / size;
      for (int i = 0; i < unknowns_; ++i) {
        if (rows_[r][i] != 0) entries.emplace_back(static_cast<int>(r), i, rows_[r][i] / size);
      }
    }
    problem.constraints.resize(static_cast<int>(rows_.size()), unknowns_);
    problem.constraints.setFromTriplets(entries.begin(), entries.end());
    return linalg::solve_least_change(problem);
  }

 private:
  int unknowns_;
  std::vector<Eigen::VectorXd> rows_;
  std::vector<double> targets_;
};

// Function that returns the stiffness of a bond. `row` is the row of the bond's lower end, counted from the face;
// `across` and `away` are the bond's steps along the face and away from the face.
using Layers = std::function<Entry(int row, int across, int away)>;

// Kind of bond, given by the bond's step. A kind with across > 0 and away > 0 stands for two mirrored bonds, so that
// `pair` is 2.
struct Kind {
  int across, away;
  double bulk, pair;
};

std::vector<Kind> kinds_of(const std::vector<BondOffset>& family) {
  std::vector<Kind> kinds;
  for (const BondOffset& o : family) {
    const Eigen::Vector2i step = o.step.cast<int>();
    if (step.x() < 0) continue;
    kinds.push_back({step.x(), step.y(), o.bulk_stiffness, step.x() > 0 && step.y() > 0 ? 2.0 : 1.0});
  }
  return kinds;
}

// Adds the equations of the third moments 112 and 222 of the points in one row; the moments 111 and 122 vanish by
// symmetry. `top` is the row on the opposite face.
void add_moments(Equations& equations, const std::vector<Kind>& kinds, const Layers& layers, int row, int top) {
  const double surface = row == 0 ? 1 : row == top ? -1 : 0;  // minus the node's surface vector
  for (int power = 2; power >= 0; power -= 2) {
    equations.begin(surface * (power == 2 ? 1.0 / 3 : 1.0));
    for (const Kind& kind : kinds) {
      if (kind.away == 0) continue;
      const double square = kind.across * kind.across + kind.away * kind.away;
      const double moment =
          kind.pair * (power == 2 ? kind.across * kind.across * kind.away : kind.away * kind.away * kind.away) / square;
      if (moment == 0) continue;
      if (row + kind.away <= top) equations.add(moment, layers(row, kind.across, kind.away));
      if (row >= kind.away) equations.add(-moment, layers(row - kind.away, kind.across, kind.away));
    }
  }
}

// Weight of a bond at the height y in the flux conditions: its contribution to the moment of C1111 of the given order
// over the cross-section of a strip. Along a strip the moments of orders 0 to 2 are conserved; they belong to symmetric
// gradients of Killing tensors. The end of a strip can be balanced only if these moments equal those of the cell
// network, in which every edge and diagonal of a cell has the stiffness C1111 / 3 and which is exact for every body.
double flux_weight(const Kind& kind, double y, int order) {
  const double a2 = kind.across * kind.across, b2 = kind.away * kind.away, common = kind.pair * a2 / (a2 + b2);
  if (order < 2) return common * a2 * (order == 0 ? 1 : y);
  return common * (y * y * a2 + (a2 - 1) / 12 * b2);
}

double cell_network_flux(int cells) {
  const double middle = 0.5 * cells, stiffness = 1.0 / 3;
  double second = 0;
  for (int row = 0; row <= cells; ++row) {
    second += stiffness * (row == 0 || row == cells ? 1 : 2) * (row - middle) * (row - middle);
    if (row < cells) second += stiffness * (row + 0.5 - middle) * (row + 0.5 - middle);
  }
  return second;
}

void add_strip_fluxes(Equations& equations, const std::vector<Kind>& kinds, const Layers& layers, int cells) {
  for (int order = 0; order <= 2; order += 2) {
    equations.begin(order == 0 ? cells : cell_network_flux(cells));
    for (const Kind& kind : kinds) {
      for (int row = 0; row + kind.away <= cells; ++row) {
        const double weight = flux_weight(kind, row + 0.5 * kind.away - 0.5 * cells, order);
        if (weight != 0) equations.add(weight, layers(row, kind.across, kind.away));
      }
    }
  }
}

// Adds the conditions under which strips of any height N >= 2 m (m: horizon ratio) have the moments of C1111 of the
// cell network (flux_weight()), as conditions for one face. M0, M1, M2 are the moments, about the face, of the
// differences between the stiffnesses near the face and the bulk stiffnesses. About the strip's middle both faces add
//   F2 = 2 (M2 - N M1 + N^2/4 M0)
// to the second moment of the bulk stiffnesses. The two heights N = 2 m and N = 2 m + 1 determine M1 and M2.
void add_face_fluxes(Equations& equations, const std::vector<Kind>& kinds, const Layers& layers, int m) {
  const auto excess = [&](int cells, int order) {  // of the cell network over the bulk stiffnesses
    double sum = order == 0 ? cells : cell_network_flux(cells);
    for (const Kind& kind : kinds) {
      for (int row = 0; row + kind.away <= cells; ++row) {
        sum -= kind.bulk * flux_weight(kind, row + 0.5 * kind.away - 0.5 * cells, order);
      }
    }
    return sum;
  };
  const double n1 = 2 * m, n2 = 2 * m + 1, m0 = 0.5 * excess(2 * m, 0);
  const double g1 = 0.5 * excess(2 * m, 2) - n1 * n1 / 4 * m0, g2 = 0.5 * excess(2 * m + 1, 2) - n2 * n2 / 4 * m0;
  const double m1 = g1 - g2, m2 = g1 + n1 * m1;
  // Moments are taken about the middle of the layer, so that the three equations differ well from each other.
  const double middle = 0.5 * m;
  const double targets[3] = {m0, m1 - middle * m0, m2 - 2 * middle * m1 + middle * middle * m0};
  for (int order = 0; order <= 2; ++order) {
    equations.begin(targets[order]);
    for (const Kind& kind : kinds) {
      for (int row = 0; row < m; ++row) {
        const double weight = flux_weight(kind, row + 0.5 * kind.away - middle, order);
        equations.add(weight, layers(row, kind.across, kind.away));
        equations.add(weight, {-1, -kind.bulk});
      }
    }
  }
}

constexpr double least_face_ratio = 0.02;

double solve_face(int m, const std::vector<Kind>& kinds, FaceTemplate& face) {
  std::vector<int> number(static_cast<std::size_t>(m) * m * m, -1);
  const auto slot = [m](int row, int across, int away) {
    return (static_cast<std::size_t>(row) * m + across) * m + away;
  };
  std::vector<double> bulk_of(static_cast<std::size_t>(m) * m, 0.0), bulk;
  for (const Kind& kind : kinds) {
    bulk_of[static_cast<std::size_t>(kind.across) * m + kind.away] = kind.bulk;
    for (int row = 0; row < m; ++row) {
      number[slot(row, kind.across, kind.away)] = static_cast<int>(bulk.size());
      bulk.push_back(kind.bulk);
    }
  }
  const auto stiffness = [&](int row, int across, int away) -> Entry {
    if (row < m) return {number[slot(row, across, away)], 0};
    return {-1, bulk_of[static_cast<std::size_t>(across) * m + away]};
  };
  Equations equations(static_cast<int>(bulk.size()));
  const Layers half_plane = [&](int row, int across, int away) { return stiffness(row, across, away); };
  for (int row = 0; row < 2 * m; ++row) add_moments(equations, kinds, half_plane, row, 1 << 20);
  add_face_fluxes(equations, kinds, half_plane, m);
  const linalg::LeastChangeResult result =
      equations.solve(Eigen::Map<Eigen::VectorXd>(bulk.data(), bulk.size()), least_face_ratio);
  for (const Kind& kind : kinds) {
    for (int row = 0; row < m; ++row) {
      face.ratio(row, kind.across, kind.away) = result.values[number[slot(row, kind.across, kind.away)]] / kind.bulk;
    }
  }
  return result.residual;
}

double solve_strip(int m, int cells, const std::vector<Kind>& kinds, FaceTemplate& strip) {
  std::vector<int> number(static_cast<std::size_t>(cells + 1) * m * m, -1);
  const auto slot = [m](int row, int across, int away) {
    return (static_cast<std::size_t>(row) * m + across) * m + away;
  };
  std::vector<double> bulk;
  for (const Kind& kind : kinds) {
    for (int row = 0; row + kind.away <= cells; ++row) {
      const int mirrored = cells - row - kind.away;
      if (mirrored < row) {
        number[slot(row, kind.across, kind.away)] = number[slot(mirrored, kind.across, kind.away)];
        continue;
      }
      number[slot(row, kind.across, kind.away)] = static_cast<int>(bulk.size());
      bulk.push_back(kind.bulk);
    }
  }
  const Layers layers = [&](int row, int across, int away) { return Entry{number[slot(row, across, away)], 0}; };
  Equations equations(static_cast<int>(bulk.size()));
  for (int row = 0; row <= cells; ++row) add_moments(equations, kinds, layers, row, cells);
  add_strip_fluxes(equations, kinds, layers, cells);
  const linalg::LeastChangeResult result =
      equations.solve(Eigen::Map<Eigen::VectorXd>(bulk.data(), bulk.size()), least_face_ratio);
  for (const Kind& kind : kinds) {
    for (int row = 0; row + kind.away <= cells; ++row) {
      strip.ratio(row, kind.across, kind.away) = result.values[number[slot(row, kind.across, kind.away)]] / kind.bulk;
    }
  }
  return result.residual;
}

std::unique_ptr<LatticeTemplates> make_templates(int m, const BondKernel& kernel) {
  auto templates = std::make_unique<LatticeTemplates>();
  templates->horizon_ratio = m;
  templates->family = bond_family(m, kernel);
  const std::vector<Kind> kinds = kinds_of(templates->family);
  templates->face = FaceTemplate(m, m);
  templates->residual = solve_face(m, kinds, templates->face);
  templates->strips.resize(2 * m);
  for (int cells = 2; cells < 2 * m; ++cells) {
    templates->strips[cells] = FaceTemplate(m, cells + 1);
    templates->residual = std::max(templates->residual, solve_strip(m, cells, kinds, templates->strips[cells]));
  }
  return templates;
}

}  // namespace

double LatticeTemplates::ratio(int below, int above, int across, int away) const {
  const int m = horizon_ratio;
  if (below >= m && above >= m) return 1;
  const int cells = below + away + above;
  if (cells < 2 * m) return cells < 2 ? 1 : strips[cells].ratio(std::min(below, above), across, away);
  // The changes of the stiffness due to both faces add up if the faces are far apart.
  double ratio = 1;
  if (below < m) ratio += face.ratio(below, across, away) - 1;
  if (above < m) ratio += face.ratio(above, across, away) - 1;
  return ratio;
}

const LatticeTemplates& lattice_templates(int horizon_ratio, const BondKernel& kernel) {
  assert(horizon_ratio >= 3 && horizon_ratio <= 8);
  struct Stored {
    std::once_flag once;
    std::unique_ptr<LatticeTemplates> templates;
  };
  static std::mutex mutex;
  static std::map<std::pair<std::string, int>, Stored> all;
  Stored* stored = nullptr;
  {
    const std::lock_guard lock(mutex);
    stored = &all[{kernel.name(), horizon_ratio}];
  }
  std::call_once(stored->once, [&] { stored->templates = make_templates(horizon_ratio, kernel); });
  return *stored->templates;
}

}  // namespace bempd::pd
