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
  earlier,  // values from before the host set new ones; they are replaced before anything else is done
  // Values in between: a step on a linear path to new values has ended on its way. Results belong to these values, and
  // the next step replaces them.
  on_path
};

// Format version of states as bytes, raised when the content of the bytes changes; and the oldest version that can be
// read, so that hosts can restore states of earlier versions of the library.
constexpr int state_format = 16, oldest_state_format = 14;

// Saved state of a run, tied to a scene by its fingerprint.
struct SavedState {
  int format = state_format;  // format of the bytes that the state was read from
  SceneFingerprint scene;
  std::uint64_t load_fingerprint = 0;
  fracture::EvolutionState evolution;
  fracture::Continuation continuation;
  std::vector<results::TipRecord> tips;  // records of tips; not in the bytes
  std::optional<RunJournal> journal;     // not in the bytes
  // Values at the end of the last step; empty before the first step. Functions are not written to bytes.
  std::optional<scene::SceneValues> in_force;
  Acting acting = Acting::values;
  double path_end = 0;               // load factor at the end of the path of values, if `acting` is on_path
  scene::SceneValues acting_values;  // values that act on the body; functions are not written to bytes
  // Values that the host has set; empty: when the state is restored, the model keeps its present ones.
  std::optional<scene::SceneValues> host_values;
  std::vector<int> frozen;  // crack and end of each tip that the host keeps frozen; only with `host_values`
  // Overloads that tips have met by the end of the last growth by cycles, in the form of numbers_of()
  // (remembered_overload.hpp).
  std::vector<double> overloads;
};

// Conversion of a saved state to bytes and back (state_bytes.cpp). from_bytes() throws Error (argument) for damaged
// bytes.
std::vector<std::uint8_t> to_bytes(const SavedState& state);
SavedState from_bytes(const std::uint8_t* bytes, std::size_t size);

// Writes a state to a file, which is replaced as a whole (state_files.cpp). Throws Error (io).
void write_state(const SavedState& state, const std::string& path);
// Reads a state from a file. Throws Error (io), or Error (argument) for damaged bytes.
SavedState read_state(const std::string& path);

}  // namespace bempd::model
