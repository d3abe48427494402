#include "coupling/stiffness_assembly.hpp"

#include <algorithm>
#include <span>

namespace bempd::coupling {

void append_pull(const std::vector<int>& unknown_of, const NodeTies& ties, int node, double cosine, double sine,
                 double size, std::vector<UnknownEntry>& entries) {
  const auto add = [&](int at, double weight) {
    if (const int x = unknown_of[2 * at]; x >= 0 && cosine != 0) entries.push_back({x, weight * cosine});
    if (const int y = unknown_of[2 * at + 1]; y >= 0 && sine != 0) entries.push_back({y, weight * sine});
  };
  const int tie = ties.tie_of(node);
  if (tie < 0) {
    add(node, size);
    return;
  }
  for (const NodeTies::Master& m : ties.masters(tie)) add(m.node, size * m.weight);
}

StiffnessAssembly::StiffnessAssembly(const std::vector<int>& unknown_of, const Terms& terms, const NodeTies& ties,
                                     const std::vector<OperatorSchurComplement>& operators, bool symmetric,
                                     const Constraints& constraints)
    : unknown_of_(unknown_of), terms_(terms), ties_(ties), operators_(operators), symmetric_(symmetric) {
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (is_general(t)) general_.push_back(t);
  }
  make_pattern(constraints);
  find_places();
}

bool StiffnessAssembly::is_general(std::size_t term) const {
  if (terms_.is_wide(term) && !symmetric_) return true;
  bool tied = false;
  if (!ties_.empty()) terms_.for_each_node(term, [&](int node) { tied = tied || ties_.tie_of(node) >= 0; });
  return tied;
}

std::vector<int> StiffnessAssembly::nodes_pulled(std::size_t term) const {
  std::vector<int> nodes;
  terms_.for_each_node(term, [&](int node) { add_node_pulled(node, nodes); });
  return nodes;
}

void StiffnessAssembly::add_node_pulled(int node, std::vector<int>& nodes) const {
  const int tie = ties_.tie_of(node);
  if (tie < 0) {
    nodes.push_back(node);
    return;
  }
  for (const NodeTies::Master& m : ties_.masters(tie)) nodes.push_back(m.node);
}

std::vector<UnknownEntry> StiffnessAssembly::pull_of(const Constraint& constraint) const {
  std::vector<UnknownEntry> pull;
  for (const TermEntry& e : constraint.pull) append_pull(unknown_of_, ties_, e.node, e.x, e.y, 1, pull);
  return pull;
}

template <class Visit>
void StiffnessAssembly::each_pair(const Constraints& constraints, const Visit& visit) const {
  for (std::size_t b = 0; b < terms_.size(); ++b) visit(terms_.first[b], terms_.second[b]);
  const auto each_of = [&](const std::vector<int>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) visit(nodes[i], nodes[j]);
    }
  };
  for (std::size_t t : general_) each_of(nodes_pulled(t));
  for (std::size_t k = 0; k < terms_.wide.term.size(); ++k) {
    const std::span<const TermEntry> entries = terms_.wide.entries(k);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) visit(entries[i].node, entries[j].node);
    }
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    std::vector<int> nodes;
    for (const TermEntry& e : constraints[i].pull) add_node_pulled(e.node, nodes);
    each_of(nodes);
  }
  for (const OperatorSchurComplement& op : operators_) {
    std::vector<int> nodes;
    for (int dof : op.shared_dofs()) {
      if (nodes.empty() || nodes.back() != dof / 2) nodes.push_back(dof / 2);
    }
    each_of(nodes);
  }
}

linalg::Adjacency StiffnessAssembly::partners(const Constraints& constraints) const {
  const auto has_column = [&](int column, int row) { return column != row && (!symmetric_ || column < row); };
  return linalg::make_adjacency(unknown_of_.size() / 2, [&](const auto& add) {
    each_pair(constraints, [&](int a, int b) {
      if (has_column(a, b)) add(a, b);
      if (has_column(b, a)) add(b, a);
    });
  });
}

void StiffnessAssembly::make_pattern(const Constraints& constraints) {
  linalg::Adjacency partners = this->partners(constraints);
  const auto size =
      static_cast<Eigen::Index>(std::count_if(unknown_of_.begin(), unknown_of_.end(), [](int u) { return u >= 0; }));
  matrix_.resize(size, size);
  std::vector<int> rows, column_start{0};
  rows.reserve(4 * partners.value.size() + 2 * static_cast<std::size_t>(size));
  for (int node = 0; node < static_cast<int>(unknown_of_.size() / 2); ++node) {
    const std::span<int> own = partners.of(node);
    const auto begin = own.begin(), end = own.end();
    std::sort(begin, end);
    const auto last = std::unique(begin, end);
    for (int column = 2 * node; column < 2 * node + 2; ++column) {
      if (unknown_of_[column] < 0) continue;
      const auto append = [&](int at) {
        for (int row = 2 * at; row < 2 * at + 2; ++row) {
          if (unknown_of_[row] >= 0 && (!symmetric_ || row >= column)) rows.push_back(unknown_of_[row]);
        }
      };
      auto it = begin;
      for (; it != last && *it < node; ++it) append(*it);
      append(node);
      for (; it != last; ++it) append(*it);
      column_start.push_back(static_cast<int>(rows.size()));
    }
  }
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(column_start.begin(), column_start.end(), matrix_.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
}

int StiffnessAssembly::place(int row, int column) const {
  if (row < 0 || column < 0 || (symmetric_ && row < column)) return -1;
  const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
  const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr());
}

// Finds the four entries of the block of two nodes by one search. The rows of a node are adjacent in each column, and
// both columns of a node have the same rows below the diagonal block.
void StiffnessAssembly::find_block(int row_node, int column_node, int* places) const {
  const int row_x = unknown_of_[2 * row_node], row_y = unknown_of_[2 * row_node + 1];
  int below = -1;  // number of entries from the block's first row to the end of a column
  for (int c = 0; c < 2; ++c) {
    const int column = unknown_of_[2 * column_node + c];
    if (column < 0) continue;
    const int end = matrix_.outerIndexPtr()[column + 1];
    if (below < 0) below = end - place(row_x >= 0 ? row_x : row_y, column);
    int at = end - below;
    if (row_x >= 0) places[c] = at++;
    if (row_y >= 0) places[2 + c] = at;
  }
}

void StiffnessAssembly::find_places() {
  const int entries = symmetric_ ? 4 : 8;
  bond_places_.assign(entries * terms_.size(), -1);
  std::size_t next_general = 0;
  for (std::size_t b = 0; b < terms_.size(); ++b) {
    if (next_general < general_.size() && general_[next_general] == b) {
      ++next_general;
      continue;
    }
    if (terms_.is_wide(b)) continue;
    const int low = std::min(terms_.first[b], terms_.second[b]), high = std::max(terms_.first[b], terms_.second[b]);
    int* places = bond_places_.data() + entries * b;
    find_block(high, low, places);
    if (!symmetric_) find_block(low, high, places + 4);
  }
}

void StiffnessAssembly::add(int row, int column, double value) {
  if (const int at = place(row, column); at >= 0) matrix_.valuePtr()[at] += value;
}

void StiffnessAssembly::add_general(std::size_t term, double stiffness) {
  std::vector<UnknownEntry> pull;
  terms_.for_each_entry(term,
                        [&](int node, double x, double y) { append_pull(unknown_of_, ties_, node, x, y, 1, pull); });
  for (const UnknownEntry& row : pull) {
    for (const UnknownEntry& column : pull) add(row.unknown, column.unknown, stiffness * row.weight * column.weight);
  }
}

void StiffnessAssembly::add_wide(std::span<const TermEntry> entries, double stiffness, Eigen::Matrix3Xd& diagonal) {
  double* values = matrix_.valuePtr();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const TermEntry& a = entries[i];
    diagonal.col(a.node) += stiffness * Eigen::Vector3d(a.x * a.x, a.x * a.y, a.y * a.y);
    for (std::size_t j = 0; j < i; ++j) {
      const bool descends = entries[j].node < a.node;
      const TermEntry &high = descends ? a : entries[j], &low = descends ? entries[j] : a;
      int places[4] = {-1, -1, -1, -1};
      find_block(high.node, low.node, places);
      const double block[4] = {high.x * low.x, high.x * low.y, high.y * low.x, high.y * low.y};
      for (int k = 0; k < 4; ++k) {
        if (places[k] >= 0) values[places[k]] += stiffness * block[k];
      }
    }
  }
}

void StiffnessAssembly::add_bonds(const std::vector<double>& stiffness) {
  double* values = matrix_.valuePtr();
  // Bonds of a node are summed for its diagonal block; only blocks off the diagonal have places for each bond.
  Eigen::Matrix3Xd diagonal = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(unknown_of_.size() / 2));
  const int entries = symmetric_ ? 4 : 8;
  std::size_t next_general = 0, next_wide = 0;
  for (std::size_t b = 0; b < terms_.size(); ++b) {
    const std::size_t wide_before = next_wide;
    if (terms_.is_wide(b)) ++next_wide;
    if (next_general < general_.size() && general_[next_general] == b) {
      add_general(b, stiffness[b]);
      ++next_general;
      continue;
    }
    if (next_wide > wide_before) {
      add_wide(terms_.wide.entries(wide_before), stiffness[b], diagonal);
      continue;
    }
    const double c = terms_.cosine[b], s = terms_.sine[b];
    const Eigen::Vector3d block = stiffness[b] * Eigen::Vector3d(c * c, c * s, s * s);
    diagonal.col(terms_.first[b]) += block;
    diagonal.col(terms_.second[b]) += block;
    const int* places = bond_places_.data() + entries * b;
    for (int k = 0; k < entries; ++k) {
      const int component_pair = (k % 4 + 1) / 2;  // xx, xy, xy, yy
      if (places[k] >= 0) values[places[k]] -= block[component_pair];
    }
  }
  for (Eigen::Index node = 0; node < diagonal.cols(); ++node) {
    const int x = unknown_of_[2 * node], y = unknown_of_[2 * node + 1];
    add(x, x, diagonal(0, node));
    add(y, x, diagonal(1, node));
    add(x, y, diagonal(1, node));
    add(y, y, diagonal(2, node));
  }
}

void StiffnessAssembly::add_operators(bool with_constraints) {
  for (const OperatorSchurComplement& op : operators_) {
    const auto& dofs = op.shared_dofs();
    const Eigen::MatrixXd& matrix = with_constraints ? op.schur_complement() : op.schur_complement_when_open();
    for (std::size_t c = 0; c < dofs.size(); ++c) {
      for (std::size_t r = 0; r < dofs.size(); ++r) {
        add(unknown_of_[dofs[r]], unknown_of_[dofs[c]],
            matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)));
      }
    }
  }
}

void StiffnessAssembly::add_springs(const std::vector<HoldingSpring>& springs) {
  for (const HoldingSpring& s : springs) {
    const int unknown[2] = {unknown_of_[2 * s.node], unknown_of_[2 * s.node + 1]};
    const double d[2] = {s.cosine, s.sine};
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) add(unknown[r], unknown[c], s.stiffness * d[r] * d[c]);
    }
  }
}

bool StiffnessAssembly::has_room_for(const Constraints& constraints) const {
  bool room = true;
  constraints.for_each_closed_penalty([&](const Constraint& constraint) {
    const std::vector<UnknownEntry> pull = pull_of(constraint);
    for (const UnknownEntry& row : pull) {
      for (const UnknownEntry& column : pull) {
        const int at = place(row.unknown, column.unknown);
        room = room && (at < 0 || (at < matrix_.outerIndexPtr()[column.unknown + 1] &&
                                   matrix_.innerIndexPtr()[at] == row.unknown));
      }
    }
  });
  return room;
}

void StiffnessAssembly::add_penalties(const Constraints& constraints) {
  constraints.for_each_closed_penalty([&](const Constraint& constraint) {
    const std::vector<UnknownEntry> pull = pull_of(constraint);
    for (const UnknownEntry& row : pull) {
      for (const UnknownEntry& column : pull)
        add(row.unknown, column.unknown, constraint.stiffness * row.weight * column.weight);
    }
  });
}

const Eigen::SparseMatrix<double>& StiffnessAssembly::sum(const std::vector<double>& stiffness,
                                                          const std::vector<HoldingSpring>& springs,
                                                          const Constraints* constraints) {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  add_bonds(stiffness);
  add_operators(constraints != nullptr);
  add_springs(springs);
  if (constraints) add_penalties(*constraints);
  return matrix_;
}

}  // namespace bempd::coupling
