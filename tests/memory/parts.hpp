// Calls that programs are made of.
#pragma once

#include <initializer_list>

#include "programs.hpp"

namespace memory_test {

void add(Program& program, std::initializer_list<Call> calls);

// Scene: regions, supports and loads are put into the given place of the host's arrays.
Call create();
Call free_model();
Call text_option(const char* name, const char* word);
Call number_option(const char* name, double value);
Call add_material(const bempd_material& values);          // a modulus of 0 stands for that of the lattices
bempd_material with_fracture_energy(double value = 1e6);  // steps do not reach the usual one
Call bem(int place, std::vector<double> vertices, double element_length);
Call pd(int place, std::vector<double> vertices, double spacing, int horizon_ratio);
Call body(int place, std::vector<double> vertices);
Call lattice_patch(int body, double spacing);  // around the first crack
Call hole(int place, std::vector<double> vertices);
Call crack(std::vector<double> points);
Call fix(int place, int region, int32_t edge);
Call pin(int place, double x, double y);
Call prescribe(int place, int region, int32_t edge, std::vector<double> proportional);
Call prescribe_by_function(int place, int region, int32_t edge);
Call traction(int place, int region, int32_t edge);
Call traction_by_function(int region, int32_t edge);
Call pressure(int place, int region);
Call point_force(int place, double x, double y);
Call crack_traction(int place);
Call new_load_values(int place);
Call new_support_values(int place);

// Runs.
Call listen();  // to the log
Call progress();
Call stopped_by_progress();
Call prepare();
Call step(double load_factor);
Call step_by(double increment);
Call next_event();
Call run();
Call grow(double length);
Call run_errors();

// Results.
Call field(int region, int32_t which);
Call bonds(int region);
Call reaction(int support);
Call evaluate();
Call evaluate_at(std::vector<double> places);
Call tips();
Call openings();
Call statistics();
Call history();
Call history_in(const char* path);
Call snapshot();

// States.
Call save();
Call restore();
Call to_bytes();
Call from_bytes();
Call damaged_bytes();
Call free_state();

}  // namespace memory_test
