#include "programs.hpp"

#include <cmath>

#include "parts.hpp"

namespace memory_test {

Host::Host(std::string folder_for_files)
    : numbers(200000, 0.0),
      integers(200000, 0),
      bytes(4000000, 0),
      folder(std::move(folder_for_files)),
      history_path(folder + "/history.csv"),
      snapshot_prefix(folder + "/picture") {}

Host::~Host() {
  bempd_model_free(model);
  bempd_state_free(state);
  bempd_state_free(other_state);
}

std::vector<double> books(const Host& host) {
  if (host.model == nullptr) return {};
  int64_t lines = 0;
  double load_factor = 0;
  bempd_history_count(host.model, &lines);
  bempd_load_factor(host.model, &load_factor);
  std::vector<double> all{load_factor, static_cast<double>(lines)};
  for (int64_t k = 0; k < lines; ++k) {
    bempd_history_entry line;
    bempd_history_entry_init(&line, sizeof line);
    bempd_get_history_entry(host.model, k, &line);
    all.insert(all.end(), {static_cast<double>(line.event), static_cast<double>(line.total_broken_bonds),
                           line.load_factor, line.stored_energy, line.released_energy, line.work});
  }
  return all;
}

namespace {

// A boundary element block | a lattice with a crack | another block, pulled apart at the ends, every kind of condition.
std::vector<Call> coupled_plate() {
  return {create(),
          text_option("crack.rule", "bond"),
          add_material(bempd_material{}),
          bem(0, {0, 0, 6, 0, 6, 8, 0, 8}, 2),
          pd(1, {6, 0, 15, 0, 15, 8, 6, 8}, 1, 3),
          bem(2, {15, 0, 21, 0, 21, 8, 15, 8}, 2),
          hole(2, {17, 3, 17, 5, 19, 5, 19, 3}),
          crack({10.5, 0, 10.5, 3.5}),
          prescribe(0, 0, 4, {-0.002, -0.02}),
          prescribe_by_function(1, 2, 2),
          pin(2, 0, 4),
          pressure(0, 2),
          point_force(1, 21, 8),
          traction_by_function(2, 2)};
}

Program coupled() {
  Program program{"coupled", coupled_plate()};
  add(program, {listen(),
                prepare(),
                next_event(),
                next_event(),
                field(0, BEMPD_STRESS),
                field(1, BEMPD_STRESS),
                field(1, BEMPD_DAMAGE),
                field(2, BEMPD_TRACTION),
                bonds(1),
                reaction(0),
                evaluate(),
                statistics(),
                history(),
                snapshot(),
                save(),
                to_bytes(),
                step(0.9),
                from_bytes(),
                restore(),
                next_event(),
                new_load_values(0),
                step(0.7),
                new_support_values(0),
                step(0.75),
                snapshot(),
                history(),
                field(1, BEMPD_DISPLACEMENT),
                field(1, BEMPD_BOND_STRETCH),
                free_state(),
                free_model()});
  return program;
}

// A lattice on its own, event after event.
std::vector<Call> lattice(const char* solver) {
  return {create(),
          text_option("test.solver", solver),
          add_material(bempd_material{}),
          pd(0, {0, 0, 26, 0, 26, 14, 0, 14}, 1, 3),
          crack({13.5, 0, 13.5, 4.5}),
          fix(0, 0, 4),
          prescribe(1, 0, 2, {0.02, 0.002}),
          listen(),
          progress()};
}

Program windows() {
  Program program{"windows", lattice("window")};
  add(program, {next_event(), next_event(), field(0, BEMPD_STRESS), next_event(), save(), step_by(0.02),
                field(0, BEMPD_DISPLACEMENT), reaction(1), restore(), run(), bonds(0), statistics(), free_state(),
                free_model()});
  return program;
}

// Cracks that grow as lines, in windows.
Program lines() {
  Program program{"lines", lattice("window")};
  add(program, {text_option("crack.rule", "line"), next_event(), next_event(), field(0, BEMPD_STRESS), next_event(),
                save(), next_event(), reaction(1), restore(), run(), bonds(0), free_state(), free_model()});
  return program;
}

Program plain() {
  Program program{"plain", lattice("plain")};
  // The forces on a body that has come apart are rounding, which a failure on the way alters.
  add(program, {next_event(), next_event(), step_by(0.02), save(), restore(), reaction(1), run(),
                field(0, BEMPD_DISPLACEMENT), bonds(0), free_state(), free_model()});
  return program;
}

Program cracks() {
  Program program{"cracks",
                  {create(), add_material(with_fracture_energy()), bem(0, {-1, -3, 1, -3, 1, 3, -1, 3}, 0.8),
                   crack({-1, 0.1, -0.3, 0}), pin(0, -1, -3), pin(1, 1, -3), fix(2, 0, 1), traction(0, 0, 3),
                   crack_traction(1), listen()}};
  add(program, {step(0.5), tips(), openings(), grow(0.2), tips(), evaluate_at({0.5, 1, -0.5, -1}), save(), grow(0.2),
                snapshot(), history(), restore(), tips(), new_load_values(0), step(0.4), field(0, BEMPD_TRACTION),
                free_state(), free_model()});
  return program;
}

// A crack in a lattice patch of a body: at its first step the patch gets more blocks.
Program patches() {
  Program program{
      "patches",
      {create(), number_option("error.wanted", 0.05), text_option("stepping.control", "path"),
       add_material(with_fracture_energy(1e-6)), body(0, {0, 0, 40, 0, 40, 90, 0, 90}), crack({20.3, 0, 20.3, 20}),
       lattice_patch(0, 1), fix(0, 0, 4), prescribe(1, 0, 2, {1, 1}), listen()}};
  add(program, {prepare(), next_event(), save(), next_event(), tips(), run_errors(), statistics(), restore(),
                next_event(), reaction(1), free_state(), free_model()});
  return program;
}

Program paper() {
  Program program{
      "paper",
      {create(), text_option("scheme", "paper"), add_material(bempd_material{}), bem(0, {0, 0, 6, 0, 6, 6, 0, 6}, 2),
       pd(1, {6, 0, 13, 0, 13, 6, 6, 6}, 1, 3), bem(2, {13, 0, 19, 0, 19, 6, 13, 6}, 2), crack({9.5, 0, 9.5, 2}),
       fix(0, 0, 4), prescribe(1, 2, 2, {0.02, 0.002}), listen()}};
  add(program, {prepare(), next_event(), next_event(), save(), step_by(0.05), restore(), step_by(0.05),
                field(0, BEMPD_STRESS), field(1, BEMPD_STRESS), reaction(1), free_state(), free_model()});
  return program;
}

// Calls that are refused: their sentences need memory too.
Program mistakes() {
  Program program{"mistakes", lattice("window")};
  const auto refused = [](Call call, bempd_status expected) {
    call.expected = expected;
    call.can_be_repeated = true;
    return call;
  };
  add(program, {refused(text_option("stepping.sover", "window"), BEMPD_ERROR_ARGUMENT),
                refused(pd(2, {30, 0, 31, 0, 31, 1, 30, 1}, 0.3, 3), BEMPD_ERROR_ARGUMENT),
                refused(bem(2, {30, 0, 40, 10, 40, 0, 30, 10}, 1), BEMPD_ERROR_ARGUMENT),
                refused(fix(3, 0, 9), BEMPD_ERROR_ARGUMENT), refused(field(0, 77), BEMPD_ERROR_ARGUMENT), prepare(),
                refused(crack({1, 1, 2, 2}), BEMPD_ERROR_ORDER), refused(evaluate_at({100, 100}), BEMPD_ERROR_ARGUMENT),
                step(0.1), refused(grow(1), BEMPD_ERROR_ARGUMENT), refused(damaged_bytes(), BEMPD_ERROR_ARGUMENT),
                refused(history_in("/nowhere/at/all.csv"), BEMPD_ERROR_IO),
                refused(stopped_by_progress(), BEMPD_ERROR_CANCELLED), progress(), next_event(), free_model()});
  return program;
}

// Enough elements for threads.
Program threads() {
  Program program{
      "threads",
      {create(), number_option("threads", 2), add_material(bempd_material{}), bem(0, {0, 0, 8, 0, 8, 8, 0, 8}, 0.4),
       pd(1, {8, 0, 12, 0, 12, 8, 8, 8}, 1, 3), fix(0, 0, 4), prescribe(1, 1, 2, {0.01, 0.01})}};
  add(program, {prepare(), step(0.1), field(0, BEMPD_TRACTION), reaction(1), free_model()});
  return program;
}

}  // namespace

std::vector<Program> all_programs() {
  return {coupled(), windows(), lines(), plain(), cracks(), patches(), paper(), mistakes(), threads()};
}

}  // namespace memory_test
