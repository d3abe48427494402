#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "error.hpp"
#include "hash.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

constexpr char magic[8] = {'B', 'E', 'M', 'P', 'D', 'S', 'T', '\0'};
constexpr std::uint32_t format_version = 8;
constexpr std::uint32_t byte_order_mark = 0x01020304;

// Members of the structs in a state, listed once for writing and reading.
template <class Spring, class Visit>
requires std::is_same_v<std::remove_const_t<Spring>, coupling::HoldingSpring>
void visit_members(Spring& s, Visit& visit) {
  visit(s.node), visit(s.cosine), visit(s.sine), visit(s.stiffness), visit(s.anchor);
}

template <class Line, class Visit>
requires std::is_same_v<std::remove_const_t<Line>, fracture::HistoryEntry>
void visit_members(Line& h, Visit& visit) {
  visit(h.event), visit(h.total_broken_bonds), visit(h.load_factor), visit(h.stretch_ratio), visit(h.stored_energy);
  visit(h.released_energy), visit(h.work), visit(h.energy_balance_error), visit(h.residual);
  visit(h.critical_load_factor), visit(h.critical_stored_energy), visit(h.bond_energy);
}

template <class Extension, class Visit>
requires std::is_same_v<std::remove_const_t<Extension>, fracture::CrackExtension>
void visit_members(Extension& e, Visit& visit) {
  visit(e.event), visit(e.crack), visit(e.end), visit(e.ended), visit(e.x), visit(e.y), visit(e.angle);
  visit(e.length), visit(e.crack_length), visit(e.load_factor), visit(e.rate_before), visit(e.rate_after);
  visit(e.released_energy);
}

template <class Tip, class Visit>
requires std::is_same_v<std::remove_const_t<Tip>, fracture::GrowingTip>
void visit_members(Tip& t, Visit& visit) {
  visit(t.place.x()), visit(t.place.y()), visit(t.direction.x()), visit(t.direction.y());
  visit(t.law), visit(t.energy_ratios);
}

template <class Face, class Visit>
requires std::is_same_v<std::remove_const_t<Face>, fracture::GrownFace>
void visit_members(Face& f, Visit& visit) { visit(f.term), visit(f.normal_x), visit(f.normal_y); }

template <class Samples, class Visit>
requires std::is_same_v<std::remove_const_t<Samples>, scene::SampledValues>
void visit_members(Samples& s, Visit& visit) { visit(s.constant), visit(s.proportional); }

template <class Both, class Visit>
requires std::is_same_v<std::remove_const_t<Both>, scene::SceneValues>
void visit_members(Both& values, Visit& visit) { visit(values.supports), visit(values.loads); }

// Numbers go one by one: the padding of a struct holds what lay in memory before.
class Writer {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(const T& number) { raw(&number, sizeof number); }
  void operator()(const bool& flag) { (*this)(static_cast<std::uint8_t>(flag)); }
  template <class Values>
  requires requires(const Values& values) { values.data(); }
  void operator()(const Values& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    for (auto number = values.data(); number != values.data() + values.size(); ++number) (*this)(*number);
  }
  void operator()(const coupling::HoldingSpring& spring) { visit_members(spring, *this); }
  void operator()(const fracture::HistoryEntry& line) { visit_members(line, *this); }
  void operator()(const fracture::CrackExtension& extension) { visit_members(extension, *this); }
  void operator()(const fracture::GrowingTip& tip) { visit_members(tip, *this); }
  void operator()(const fracture::GrownFace& face) { visit_members(face, *this); }
  void operator()(const scene::Values& values) {
    const auto* samples = std::get_if<scene::SampledValues>(&values);
    (*this)(samples != nullptr);
    if (samples) visit_members(*samples, *this);
  }
  void operator()(const std::optional<scene::SceneValues>& values) {
    (*this)(values.has_value());
    if (values) visit_members(*values, *this);
  }
  void raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::uint8_t> finish() {
    Hash hash;
    hash.add_bytes(bytes_.data(), bytes_.size());
    (*this)(hash.value());
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), left_(size) {}

  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(T& number) { raw(&number, sizeof number); }
  void operator()(bool& flag) {
    std::uint8_t byte;
    raw(&byte, sizeof byte);
    require(byte <= 1, "the bytes of the state are damaged: a flag is neither 0 nor 1");
    flag = byte == 1;
  }
  void operator()(coupling::Affine& values) { values.resize(count_of<double>() / 2, 2), numbers(values); }
  void operator()(Eigen::VectorXd& values) { values.resize(count_of<double>()), numbers(values); }
  template <class T>
  void operator()(std::vector<T>& values) {
    values.resize(static_cast<std::size_t>(count_of<T>()));
    numbers(values);
  }
  void operator()(coupling::HoldingSpring& spring) { visit_members(spring, *this); }
  void operator()(fracture::HistoryEntry& line) { visit_members(line, *this); }
  void operator()(fracture::CrackExtension& extension) { visit_members(extension, *this); }
  void operator()(fracture::GrowingTip& tip) { visit_members(tip, *this); }
  void operator()(fracture::GrownFace& face) { visit_members(face, *this); }
  void operator()(scene::Values& values) {
    bool sampled = false;
    (*this)(sampled);
    if (sampled) {
      visit_members(values.emplace<scene::SampledValues>(), *this);
    } else {
      values.emplace<scene::BoundaryFunction>();  // unknown
    }
  }
  void operator()(std::optional<scene::SceneValues>& values) {
    bool there = false;
    (*this)(there);
    if (there) visit_members(values.emplace(), *this);
  }
  void raw(void* target, std::size_t size) {
    require(size <= left_, "the bytes of the state end too early; give all bytes that bempd_state_to_bytes() wrote");
    std::memcpy(target, bytes_, size);
    bytes_ += size;
    left_ -= size;
  }
  std::size_t left() const { return left_; }

 private:
  template <class T>
  Eigen::Index count_of() {
    std::uint64_t count = 0;
    (*this)(count);
    // No entry is shorter than its least number, so this bounds what is allocated to a small multiple of the bytes.
    require(count <= left_ / std::min(sizeof(T), sizeof(double)),
            "the bytes of the state are damaged: an array is longer than what is left");
    return static_cast<Eigen::Index>(count);
  }
  template <class Values>
  void numbers(Values& values) {
    for (auto number = values.data(); number != values.data() + values.size(); ++number) (*this)(*number);
  }

  const std::uint8_t* bytes_;
  std::size_t left_;
};

// What a state consists of, listed once for writing and reading.
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, SavedState>
void visit_members(State& state, Visit& visit) {
  visit(state.scene.body), visit(state.scene.supports), visit(state.load_fingerprint);
  auto& e = state.evolution;
  visit(e.load_factor), visit(e.in_equilibrium), visit(e.separated);
  visit(e.events), visit(e.broken_bonds), visit(e.fragments);
  visit(e.first_unit_energy), visit(e.released_energy), visit(e.bond_energy), visit(e.work), visit(e.largest_work);
  visit(e.worst_energy_balance_error), visit(e.residual), visit(e.largest_force);
  visit(e.resistance.present), visit(e.resistance.peak), visit(e.resistance.stiffness);
  visit(e.work_out_of_balance), visit(e.contact_switches);
  visit(e.displacement), visit(e.total_displacement), visit(e.total_force);
  visit(e.stages), visit(e.springs), visit(e.unloaded), visit(e.tips), visit(e.history), visit(e.reactions);
  visit(e.extensions);
  visit(e.faces.grown), visit(e.faces.closed);
  visit(state.in_force), visit(state.on_a_way), visit(state.end_of_way);
}

void check_header(Reader& reader) {
  char found[8];
  reader.raw(found, sizeof found);
  require(std::memcmp(found, magic, sizeof magic) == 0, "the bytes are not a state of bempd");
  std::uint32_t order = 0, version = 0;
  reader(order);
  require(order == byte_order_mark, "the state was written on a machine of the other byte order");
  reader(version);
  require(version == format_version, "the state has format version ", version, "; this library reads version ",
          format_version, ": repeat the run, or go on with the version of bempd that wrote the bytes");
}

bool are_flags(const std::vector<char>& values) {
  return std::all_of(values.begin(), values.end(), [](char flag) { return flag == 0 || flag == 1; });
}

bool is_sound(const coupling::HoldingSpring& s, Eigen::Index dofs) {
  return s.node >= 0 && 2 * static_cast<Eigen::Index>(s.node) < dofs &&
         std::abs(std::hypot(s.cosine, s.sine) - 1) < 1e-6 && s.stiffness > 0 && std::isfinite(s.stiffness) &&
         std::isfinite(s.anchor);
}

// Energies may be beyond the range of numbers (CrackEvolution::energies_are_lost), nothing else may.
bool is_sound(const fracture::HistoryEntry& line) {
  return line.event >= 0 && line.total_broken_bonds >= 0 && std::isfinite(line.load_factor) &&
         std::isfinite(line.stretch_ratio) && std::isfinite(line.critical_load_factor);
}

bool is_sound(const fracture::CrackExtension& e) {
  return e.crack >= 1 && (e.end == 0 || e.end == 1) && std::isfinite(e.x) && std::isfinite(e.y);
}

void sound(bool good, const char* what) { require(good, "the bytes of the state are damaged: ", what); }

bool is_sound(const scene::Values& values) {
  const auto* samples = std::get_if<scene::SampledValues>(&values);
  if (!samples) return true;
  const auto finite = [](double value) { return std::isfinite(value); };
  return !samples->constant.empty() && samples->constant.size() == samples->proportional.size() &&
         std::all_of(samples->constant.begin(), samples->constant.end(), finite) &&
         std::all_of(samples->proportional.begin(), samples->proportional.end(), finite);
}

void require_consistent(const SavedState& state) {
  sound(!state.on_a_way || state.in_force, "it has no values between which it is");
  sound(std::isfinite(state.end_of_way), "a load factor is not a finite number");
  if (!state.in_force) return;
  for (const std::vector<scene::Values>& all : {state.in_force->supports, state.in_force->loads})
    for (const scene::Values& values : all) sound(is_sound(values), "the values of a load or a support are none");
}

void require_consistent(const fracture::EvolutionState& e) {
  const Eigen::Index dofs = e.total_displacement.size();
  sound(dofs % 2 == 0 && e.displacement.rows() == dofs && e.total_force.size() == dofs &&
            2 * static_cast<Eigen::Index>(e.unloaded.size()) == dofs,
        "its arrays are not of the same nodes");
  sound(std::isfinite(e.load_factor) && e.displacement.allFinite() && e.total_displacement.allFinite() &&
            e.total_force.allFinite(),
        "a displacement or a force is not a finite number");
  sound(e.events >= 0 && e.broken_bonds >= 0 && e.fragments >= 0 && e.contact_switches >= 0, "a count is negative");
  sound(are_flags(e.unloaded) && are_flags(e.faces.closed), "a flag is neither 0 nor 1");
  sound(std::all_of(e.springs.begin(), e.springs.end(), [&](const auto& spring) { return is_sound(spring, dofs); }),
        "a spring that holds a free piece is at no node or no spring");
  sound(std::all_of(e.history.begin(), e.history.end(), [](const auto& line) { return is_sound(line); }),
        "a line of the history is none");
  sound(e.history.empty() ? e.reactions.empty() : e.reactions.size() % (2 * e.history.size()) == 0,
        "its reactions are not those of the lines of its history");
  sound(std::all_of(e.reactions.begin(), e.reactions.end(), [](double force) { return std::isfinite(force); }),
        "a reaction is not a finite number");
  sound(std::all_of(e.extensions.begin(), e.extensions.end(), [](const auto& one) { return is_sound(one); }),
        "an extension of a crack is none");
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const SavedState& state) {
  Writer writer;
  writer.raw(magic, sizeof magic);
  writer(byte_order_mark);
  writer(format_version);
  visit_members(state, writer);
  return writer.finish();
}

SavedState from_bytes(const std::uint8_t* bytes, std::size_t size) {
  Reader reader(bytes, size);
  check_header(reader);
  std::uint64_t stored = 0;
  require(reader.left() > sizeof stored, "the bytes of the state end too early");
  Hash hash;
  hash.add_bytes(bytes, size - sizeof stored);
  std::memcpy(&stored, bytes + size - sizeof stored, sizeof stored);
  require(stored == hash.value(), "the bytes of the state are damaged: their checksum does not match");
  SavedState state;
  visit_members(state, reader);
  require(reader.left() == sizeof stored, "the bytes of the state are damaged: something is left over");
  require_consistent(state);
  require_consistent(state.evolution);
  return state;
}

}  // namespace bempd::model
