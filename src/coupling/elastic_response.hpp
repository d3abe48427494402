#pragma once

#include <Eigen/Core>
#include <span>

#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Forces and energies of a system's operators, energy terms and closed penalties (not of holding springs) at given
// displacements, numbered 2 * node + component. The load factor matters where rest elongations or rest displacements
// depend on it. The operators must be condensed before.
class ElasticResponse {
 public:
  explicit ElasticResponse(const SystemParts& parts) : parts_(parts) {}

  // Whether there can be forces at zero displacement, due to rest elongations, rest displacements or closed exact
  // constraints.
  bool has_offsets() const;
  // Whether the forces and gaps at this displacement are proportional to the load factor.
  bool is_proportional(const Affine& displacement) const;

  // Nodal forces; forces on tied nodes are moved to their masters.
  Eigen::VectorXd internal_force(const Eigen::VectorXd& displacement, double load_factor = 0) const;
  // Nodal forces of only the energy terms with these numbers; forces on tied nodes are not moved to their masters.
  Eigen::VectorXd force_of_terms(std::span<const int> terms, const Eigen::VectorXd& displacement,
                                 double load_factor) const;

  // Energy at a displacement and a load factor.
  double energy(const Eigen::VectorXd& displacement, double load_factor = 0) const;
  // Energy at a displacement and a load factor. The internal forces `force` at this displacement are given, which saves
  // most of the work.
  double energy(const Eigen::VectorXd& displacement, double load_factor, const Eigen::VectorXd& force) const;
  // Derivative of the energy by the load factor at a fixed displacement, due to the proportional parts of rest
  // elongations and rest displacements.
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;
  // Strain energy of the proportional part of a displacement alone, that is at the load factor 1 without constant
  // parts; rest elongations and rest displacements count with their proportional parts.
  double unit_energy(const Eigen::VectorXd& proportional) const;

 private:
  const SystemParts& parts_;
};

}  // namespace bempd::coupling
