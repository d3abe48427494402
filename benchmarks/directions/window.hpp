#pragma once

#include "body.hpp"

namespace directions {

// The body in its elastic state, with the points of the window kept and everything else condensed; bonds of the window
// may lose stiffness, each loss a rank-one change in closed form.
class Window {
 public:
  explicit Window(Body& body);

  int local(int point) const { return local_[static_cast<std::size_t>(point)]; }  // -1 outside
  const std::vector<int>& points() const { return points_; }
  const std::vector<int>& bonds() const { return bonds_; }  // of the body, both ends in the window

  Point displacement(int point) const { return displacement_.segment<2>(2 * local(point)); }
  double elongation(int bond) const;
  double stretch(int bond) const { return elongation(bond) / body_.bonds[static_cast<std::size_t>(bond)].length; }
  double stiffness(int bond) const { return stiffness_[static_cast<std::size_t>(bond)]; }

  // Takes `loss` from the stiffness of a bond; returns the energy that this releases at load factor one, or -1 where it
  // would leave something loose: then nothing is changed.
  double soften(int bond, double loss);

  // Energy at load factor one that taking the whole bond out would release, k e^2 / 2 / (1 - k c.K^-1 c) with its
  // elongation e = c.u: what soften() would return. From compliances c.K^-1 c that are kept for all bonds.
  double release_of(int bond) const;
  void keep_compliances();

  // Takes a bond out that holds something loose only.
  void forget(int bond) { stiffness_[static_cast<std::size_t>(bond)] = 0; }

  // Energy that breaking all these bonds would release.
  double release_of(const std::vector<int>& bonds) const;

 private:
  double flexibility(int bond, int other) const;
  void fold();

  const Body& body_;
  std::vector<int> points_, local_, bonds_, place_;  // place_: of a bond of the body in bonds_
  std::vector<double> stiffness_;
  Eigen::MatrixXd flexibility_, changes_;  // flexibility_ + changes_ changes_^T
  int pending_ = 0;
  Eigen::VectorXd displacement_;
  std::vector<double> compliance_;  // of the window's bonds where they are kept
};

// Elastic energy of the body at load factor one, without the bonds that are out, by a solution of its own.
double elastic_energy(const Body& body, const std::vector<char>& out);

// Energy per length of the uncracked strip at load factor one, from its middle.
double strip_release(Layout layout, double half_height, double growth);

}  // namespace directions
