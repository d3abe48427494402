#pragma once

#include <cstdint>
#include <string_view>

#include "model/accuracy.hpp"
#include "model/crack_growth.hpp"
#include "model/crack_results.hpp"
#include "model/crack_treatments.hpp"
#include "model/edge_results.hpp"
#include "model/fatigue.hpp"
#include "model/host_requests.hpp"
#include "model/load_cases.hpp"
#include "model/load_driver.hpp"
#include "model/load_values.hpp"
#include "model/pieces.hpp"
#include "model/preparation.hpp"
#include "model/prepared_scene.hpp"
#include "model/result_files.hpp"
#include "model/results.hpp"
#include "model/run_reports.hpp"
#include "model/solver_choice.hpp"
#include "model/states.hpp"
#include "scene/names.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Model of a host: the scene, its options and names, and the parts that prepare the scene, drive its loads, grow its
// cracks, answer requests for results, and save states of the run. Each part knows the model, and asks other parts
// through the model.
class Model {
 public:
  scene::Options& options() { return options_; }
  const scene::Options& options() const { return options_; }
  // Sets a text option; results that it changes are out of date then.
  void set_option_text(std::string_view name, std::string_view value);
  // Names that the host gave to parts of the scene; messages and files show them.
  scene::Names& names() { return names_; }
  const scene::Names& names() const { return names_; }
  const scene::Scene& scene() const { return preparation_.scene(); }
  // Scene for changes by the host. Throws Error (order) once the model is prepared.
  scene::Scene& editable_scene();

  void prepare();
  PreparedScene& prepared();        // prepares the model if needed
  PreparedScene& in_equilibrium();  // prepares the model if needed, and solves it under the values that were set
  const PreparedScene* prepared_or_null() const { return preparation_.prepared(); }
  double load_factor() const;
  std::int64_t generation() const { return preparation_.generation(); }
  // Cleans up after a failed call: discards what the call has prepared. A body whose first equilibrium was not found
  // (`unsolvable`) is discarded too, so that the host can correct the scene.
  void call_failed(bool was_prepared, bool unsolvable) noexcept;

  // Parts that prepare: the scene and its operators, the accuracy of bodies, treatments of cracks, and the solver.
  Preparation& preparation() { return preparation_; }
  Accuracy& accuracy() { return accuracy_; }
  CrackTreatments& treatments() { return treatments_; }
  AttachedSolver& solver() { return solver_; }

  // Parts that drive the run: values of loads, steps and programs, growth by lengths and by cycles.
  LoadValues& loads() { return loads_; }
  LoadDriver& driver() { return driver_; }
  CrackGrowth& growth() { return growth_; }
  Fatigue& fatigue() { return fatigue_; }
  const Fatigue& fatigue() const { return fatigue_; }

  // Parts that give results, at present or under load cases.
  Results& results() { return results_; }
  Pieces& pieces() { return pieces_; }
  EdgeResults& edges() { return edges_; }
  CrackResults& cracks() { return cracks_; }
  const CrackResults& cracks() const { return cracks_; }
  LoadCases& load_cases() { return load_cases_; }
  const LoadCases& load_cases() const { return load_cases_; }
  ResultFiles& files() { return files_; }
  const ResultFiles& files() const { return files_; }

  // Parts for saved states of the run, for requests of the host to a running call, and for the lines of the log.
  States& states() { return states_; }
  HostRequests& host() { return host_; }
  RunReports& reports() { return reports_; }

 private:
  scene::Options options_;
  scene::Names names_;
  HostRequests host_;
  RunReports reports_{*this};
  AttachedSolver solver_{*this};
  Preparation preparation_{*this};
  LoadValues loads_{*this};
  LoadDriver driver_{*this};
  CrackGrowth growth_{*this};
  Results results_{*this};
  Pieces pieces_{*this};
  EdgeResults edges_{*this};
  CrackResults cracks_{*this};
  ResultFiles files_{*this};
  Fatigue fatigue_{*this};
  LoadCases load_cases_{*this};
  Accuracy accuracy_{*this};
  CrackTreatments treatments_{*this};
  States states_{*this};
};

}  // namespace bempd::model
