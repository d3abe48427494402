#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "error.hpp"
#include "hash.hpp"
#include "model/state_checks.hpp"

namespace bempd::model {

namespace {

constexpr char magic[8] = {'B', 'E', 'M', 'P', 'D', 'S', 'T', '\0'};
constexpr std::uint32_t byte_order_mark = 0x01020304;

// Members of the structs in a state, listed once for both writing and reading.
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
  visit(h.critical_load_factor), visit(h.critical_stored_energy), visit(h.bond_energy), visit(h.load_factor_before);
  visit(h.stored_energy_before), visit(h.work_before), visit(h.resistance_before), visit(h.resistance), visit(h.ties);
}
template <class Extension, class Visit>
requires std::is_same_v<std::remove_const_t<Extension>, fracture::CrackExtension>
void visit_members(Extension& e, Visit& visit) {
  for (auto* number :
       {&e.x, &e.y, &e.angle, &e.length, &e.crack_length, &e.load_factor, &e.rate_before, &e.rate_after,
        &e.released_energy, &e.from_x, &e.from_y, &e.factor_1, &e.factor_2, &e.resistance, &e.surface_energy})
    visit(*number);
  visit(e.event), visit(e.crack), visit(e.end), visit(e.state);
}
template <class Id, class Visit>
requires std::is_same_v<std::remove_const_t<Id>, crack::TipId>
void visit_members(Id& id, Visit& visit) { visit(id.crack), visit(id.end); }
template <class Tip, class Visit>
requires std::is_same_v<std::remove_const_t<Tip>, fracture::GrowingTip>
void visit_members(Tip& t, Visit& visit) {
  visit(t.place.x()), visit(t.place.y()), visit(t.direction.x()), visit(t.direction.y());
  visit(t.law), visit(t.energy_ratios), visit(t.id), visit(t.state);
  if (visit.format > 15) visit(t.even_ahead), visit(t.grown);
}
template <class Face, class Visit>
requires std::is_same_v<std::remove_const_t<Face>, fracture::GrownFace>
void visit_members(Face& f, Visit& visit) { visit(f.term), visit(f.normal_x), visit(f.normal_y); }
template <class Faces, class Visit>
requires std::is_same_v<std::remove_const_t<Faces>, fracture::FaceState>
void visit_members(Faces& f, Visit& visit) {
  std::vector<char> exact;  // the first flags of `closed`, which bytes of format 14 have in a list of their own
  visit(f.grown), visit(f.closed), visit(exact), visit(f.pending);
  if constexpr (!std::is_const_v<Faces>) f.closed.insert(f.closed.begin(), exact.begin(), exact.end());
}
template <class Samples, class Visit>
requires std::is_same_v<std::remove_const_t<Samples>, scene::SampledValues>
void visit_members(Samples& s, Visit& visit) { visit(s.constant), visit(s.proportional); }
template <class Placed, class Visit>
requires std::is_same_v<std::remove_const_t<Placed>, scene::PlacedValues>
void visit_members(Placed& p, Visit& visit) { visit(p.fractions), visit(p.constant), visit(p.proportional); }
template <class Change, class Visit>
requires std::is_same_v<std::remove_const_t<Change>, coupling::StageChange>
void visit_members(Change& c, Visit& visit) { visit(c.term), visit(c.stage); }
template <class Entry, class Visit>
requires std::is_same_v<std::remove_const_t<Entry>, coupling::TermEntry>
void visit_members(Entry& e, Visit& visit) { visit(e.node), visit(e.x), visit(e.y); }
template <class Place, class Visit>
requires std::is_same_v<std::remove_const_t<Place>, coupling::Constraint>
void visit_members(Place& p, Visit& visit) { visit(p.pull), visit(p.stiffness); }
template <class Change, class Visit>
requires std::is_same_v<std::remove_const_t<Change>, coupling::FactorChange>
void visit_members(Change& c, Visit& visit) { visit(c.adds), visit(c.end), visit(c.unknown), visit(c.weight); }
template <class Origin, class Visit>
requires std::is_same_v<std::remove_const_t<Origin>, coupling::FactorOrigin>
void visit_members(Origin& o, Visit& visit) {
  visit(o.stages), visit(o.springs), visit(o.closed), visit(o.places), visit(o.changes);
}
template <class Place, class Visit>
requires std::is_same_v<std::remove_const_t<Place>, fracture::Zone>
void visit_members(Place& zone, Visit& visit) {
  for (auto* point : {&zone.centre, &zone.axis, &zone.low, &zone.high, &zone.inner_low, &zone.inner_high})
    visit(point->x()), visit(point->y());
}
template <class Look, class Visit>
requires std::is_same_v<std::remove_const_t<Look>, fracture::WindowOrigin::Look>
void visit_members(Look& l, Visit& visit) { visit(l.after), visit(l.load_factor), visit(l.largest_force); }
template <class Window, class Visit>
requires std::is_same_v<std::remove_const_t<Window>, fracture::WindowOrigin>
void visit_members(Window& w, Visit& visit) {
  visit(w.options.tie_band), visit(w.options.max_breaks_per_solve), visit(w.options.ahead), visit(w.options.control);
  visit(w.load_factor), visit(w.displacement), visit(w.faces), visit(w.looks), visit(w.events_performed);
  visit(w.is_behind), visit(w.has_changed_terms), visit(w.needs_whole_body), visit(w.tips);
}
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, fracture::Continuation>
void visit_members(State& c, Visit& visit) {
  visit(c.whole_body_events), visit(c.patience), visit(c.most_events);
  visit(c.place.zones), visit(c.place.nodes), visit(c.place.are_last);
  visit(c.places_met), visit(c.barred), visit(c.changes_that_bar), visit(c.factor), visit(c.window);
}
// Form in which the values of a condition are written. Functions are not written.
enum class Form : std::uint8_t { function, samples, places };

template <class Both, class Visit>
requires std::is_same_v<std::remove_const_t<Both>, scene::SceneValues>
void visit_members(Both& values, Visit& visit) { visit(values.supports), visit(values.loads); }

// Writes structs number by number, because the padding between their members is undefined.
class Writer {
 public:
  static constexpr int format = state_format;
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
  template <class Struct>
  requires requires(const Struct& one, Writer& writer) { visit_members(one, writer); }
  void operator()(const Struct& one) { visit_members(one, *this); }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void operator()(const Choice& choice) { (*this)(static_cast<std::uint8_t>(choice)); }
  void operator()(const scene::Values& values) {
    const auto* samples = std::get_if<scene::SampledValues>(&values);
    const auto* placed = std::get_if<scene::PlacedValues>(&values);
    (*this)(static_cast<std::uint8_t>(samples ? Form::samples : placed ? Form::places : Form::function));
    if (samples) visit_members(*samples, *this);
    if (placed) visit_members(*placed, *this);
  }
  template <class T>
  void operator()(const std::optional<T>& one) {
    (*this)(one.has_value());
    if (one) (*this)(*one);
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
  int format = state_format;  // of the bytes
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
  template <class Struct>
  requires requires(Struct& one, Reader& reader) { visit_members(one, reader); }
  void operator()(Struct& one) { visit_members(one, *this); }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void operator()(Choice& choice) {
    std::uint8_t number = 0;
    (*this)(number);
    choice = static_cast<Choice>(number);
  }
  void operator()(scene::Values& values) {
    std::uint8_t form = 0;
    (*this)(form);
    require(form <= static_cast<std::uint8_t>(Form::places), "the bytes of the state are damaged: values have no form");
    switch (static_cast<Form>(form)) {
      case Form::samples:
        return visit_members(values.emplace<scene::SampledValues>(), *this);
      case Form::places:
        return visit_members(values.emplace<scene::PlacedValues>(), *this);
      case Form::function:
        values.emplace<scene::BoundaryFunction>();  // unknown
    }
  }
  template <class T>
  void operator()(std::optional<T>& one) {
    bool there = false;
    (*this)(there);
    if (there) (*this)(one.emplace());
  }
  void raw(void* target, std::size_t size) {
    require(size <= left_, "the bytes of the state end too early; give all bytes that bempd_state_to_bytes() wrote");
    std::memcpy(target, bytes_, size);
    bytes_ += size, left_ -= size;
  }
  std::size_t left() const { return left_; }

 private:
  template <class T>
  Eigen::Index count_of() {
    std::uint64_t count = 0;
    (*this)(count);
    // The count is limited by the bytes left (no entry is shorter than its smallest number), and so is the memory.
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

// Members of a saved state, listed once for both writing and reading.
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, SavedState>
void visit_members(State& state, Visit& visit) {
  visit(state.scene.body), visit(state.scene.supports), visit(state.load_fingerprint);
  auto& e = state.evolution;
  visit(e.load_factor), visit(e.in_equilibrium), visit(e.separated), visit(e.events), visit(e.broken_bonds);
  visit(e.fragments), visit(e.first_unit_energy), visit(e.released_energy), visit(e.bond_energy), visit(e.work);
  visit(e.largest_work), visit(e.worst_energy_balance_error), visit(e.residual), visit(e.largest_force);
  visit(e.resistance.present), visit(e.resistance.peak), visit(e.resistance.stiffness);
  visit(e.work_out_of_balance), visit(e.contact_switches), visit(e.ties);
  visit(e.displacement), visit(e.total_displacement), visit(e.total_force);
  visit(e.stages), visit(e.springs), visit(e.unloaded), visit(e.tips), visit(e.history);
  visit(e.reactions), visit(e.reactions_before), visit(e.support_displacements), visit(e.extensions), visit(e.faces),
      visit(e.stopped);
  visit(state.in_force), visit(state.acting), visit(state.end_of_way), visit(state.acting_values);
  visit(state.scene.loads), visit(state.said), visit(state.continuation);
}

// Reads the header of a state's bytes and returns their format version.
int read_header(Reader& reader) {
  char found[8];
  reader.raw(found, sizeof found);
  require(std::memcmp(found, magic, sizeof magic) == 0, "the bytes are not a state of bempd");
  std::uint32_t order = 0, version = 0;
  reader(order);
  require(order == byte_order_mark, "the state was written on a machine of the other byte order");
  reader(version);
  require(version >= oldest_state_format && version <= state_format, "the state has format version ", version,
          "; this library reads versions ", oldest_state_format, " to ", state_format,
          ": repeat the run, or go on with the version of bempd that wrote the bytes");
  return static_cast<int>(version);
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const SavedState& state) {
  Writer writer;
  writer.raw(magic, sizeof magic), writer(byte_order_mark), writer(static_cast<std::uint32_t>(state_format));
  visit_members(state, writer);
  if (!state.frozen.empty() || !state.overloads.empty()) writer(state.frozen);
  if (!state.overloads.empty()) writer(state.overloads);
  return writer.finish();
}

SavedState from_bytes(const std::uint8_t* bytes, std::size_t size) {
  Reader reader(bytes, size);
  reader.format = read_header(reader);
  std::uint64_t stored = 0;
  require(reader.left() > sizeof stored, "the bytes of the state end too early");
  Hash hash;
  hash.add_bytes(bytes, size - sizeof stored);
  std::memcpy(&stored, bytes + size - sizeof stored, sizeof stored);
  require(stored == hash.value(), "the bytes of the state are damaged: their checksum does not match");
  SavedState state;
  state.format = reader.format;
  visit_members(state, reader);
  if (reader.left() > sizeof stored) reader(state.frozen);
  if (reader.left() > sizeof stored) reader(state.overloads);
  require(reader.left() == sizeof stored, "the bytes of the state are damaged: something is left over");
  require_consistent(state);
  return state;
}

}  // namespace bempd::model
