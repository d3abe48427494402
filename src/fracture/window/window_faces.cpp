// What the faces of cracks do in the states that a certificate computes for the whole body.
#include <algorithm>
#include <functional>

#include "fracture/window/window_certificate.hpp"

namespace bempd::fracture {

void WindowCertificate::look_at_faces(const std::vector<int>& solved, const Eigen::MatrixXd& whole) {
  if (faces_->is_idle()) return;
  const int parts = proportional_ ? 1 : 2;
  for (std::size_t s = 0; s < solved.size(); ++s) {
    const auto first = parts * static_cast<Eigen::Index>(s), last = first + parts - 1;
    const std::function<double(int)> constant = [&](int dof) { return proportional_ ? 0 : whole(first, dof); };
    const std::function<double(int)> proportional = [&](int dof) { return whole(last, dof); };
    const std::array<double, 2> largest{proportional_ ? 0 : whole.row(first).lpNorm<Eigen::Infinity>(),
                                        whole.row(last).lpNorm<Eigen::Infinity>()};
    snapshots_[solved[s]].faces_hold = faces_->holds(solved[s], constant, proportional, largest);
  }
}

// Where faces open or close between two snapshots: a state in between to look at; -1 where there is none, and then what
// comes from there on has no end but the first of the two.
int WindowCertificate::next_between_faces(int& end) {
  const auto moved = std::find_if(snapshots_.begin(), snapshots_.end(),
                                  [](const auto& snapshot) { return !snapshot.second.faces_hold; });
  if (moved == snapshots_.end() || moved->first > end) return -1;
  const int before = std::prev(moved)->first;
  ended_at_faces_ = true;
  end = moved->first == before + 1 ? before : std::min(end, moved->first);
  return moved->first == before + 1 ? -1 : (before + moved->first) / 2;
}

}  // namespace bempd::fracture
