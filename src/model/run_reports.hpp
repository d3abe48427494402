#pragma once

#include <cstdint>
#include <string>

#include "model/answers.hpp"
#include "model/prepared_scene.hpp"

namespace bempd::model {

class Model;

// Runs code that only reports on finished work, and ignores its failures: a call must not fail for lack of memory for a
// message.
template <class Body>
void say(const Body& body) noexcept {
  try {
    body();
  } catch (...) {
  }
}

// Lines of a model's log: what was prepared, what steps have done, and warnings, each once.
class RunReports {
 public:
  explicit RunReports(Model& model) : model_(model) {}

  // Writes a line to the log, with the host's names for parts of the scene.
  void log(int level, const std::string& message) const;

  void tell_of_preparation() const;
  void tell_of_step(const StepResult& result, std::int64_t new_fragments, bool upwards);
  // Logs the growth of cracks; `before` is the scene with shorter cracks.
  void tell_of_growth(const fracture::Growth& growth, const PreparedScene& before) const;
  // Logs the size of the lattice patches after their blocks have changed.
  void tell_of_layout() const;
  // Warns once that lattice patches cannot get more blocks, and why.
  void warn_of_patch(const std::string& why);
  // Warns once that a bond has broken near a patch's border.
  void warn_of_break(const Point& place);
  void tell_of_whole_body();
  void warn_of_equilibrium();

 private:
  void warn_of_condition();
  void warn_of_held_parts();
  void warn_of_blas() const;
  void warn_of_overlap();
  void warn_of_interface();
  void tell_of_hinge();
  bool is_heard() const;

  Model& model_;
  bool warned_of_energies_ = false, warned_of_condition_ = false, warned_of_overlap_ = false;
  bool warned_of_interface_ = false, warned_of_hinge_ = false, told_of_whole_body_ = false, warned_of_patch_ = false,
       warned_of_break_ = false;
};

}  // namespace bempd::model
