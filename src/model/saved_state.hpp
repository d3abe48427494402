#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fracture/continuation.hpp"
#include "fracture/evolution_state.hpp"
#include "model/fingerprint.hpp"
#include "model/run_journal.hpp"
#include "results/tip_record.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

// Origin of the values of loads and supports that act on the body.
enum class Acting : std::uint8_t {
  values,   // the values that the host has set
  earlier,  // earlier values: they have to be replaced before anything else is done
  on_path   // values between, where a step on a straight line was left: results show them, steps replace them
};

// Version of the bytes of states, raised when their content changes, and the oldest version that is still read, so that
// hosts can restore states of earlier versions of the library.
constexpr int state_format = 16, oldest_state_format = 14;

// Saved state of a run, tied to a scene by its fingerprint.
struct SavedState {
  int format = state_format;  // of the bytes that it was read from
  SceneFingerprint scene;
  std::uint64_t load_fingerprint = 0;
  fracture::EvolutionState evolution;
  fracture::Continuation continuation;
  std::vector<results::TipRecord> tips;  // not among its bytes
  std::optional<RunJournal> journal;     // likewise
  // Values at the end of the last step; empty before the first one. Functions are not written to bytes.
  std::optional<scene::SceneValues> in_force;
  Acting acting = Acting::values;
  double path_end = 0;
  scene::SceneValues acting_values;               // values that act on the body; functions are not written to bytes
  std::optional<scene::SceneValues> host_values;  // by the host, if the state is to bring them back
  std::vector<int> frozen;        // crack and end of each tip that the host keeps, together with `host_values`
  std::vector<double> overloads;  // that tips have met by the end of the last growth by cycles, as numbers
};

// Conversion of a saved state to bytes and back (state_bytes.cpp); from_bytes() throws Error (argument) for damaged
// bytes.
std::vector<std::uint8_t> to_bytes(const SavedState& state);
SavedState from_bytes(const std::uint8_t* bytes, std::size_t size);

// Writes a state to a file, which is replaced as a whole, or reads it (state_files.cpp). Both throw Error (io).
void write_state(const SavedState& state, const std::string& path);
SavedState read_state(const std::string& path);

}  // namespace bempd::model
