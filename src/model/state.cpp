#include <cstring>
#include <type_traits>

#include "error.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

constexpr char magic[8] = {'B', 'E', 'M', 'P', 'D', 'S', 'T', '\0'};
constexpr std::uint32_t format_version = 1;
constexpr std::uint32_t byte_order_mark = 0x01020304;

// FNV-1a, 64 bits.
class Hash {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.data(), values.size() * sizeof(T));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

class Writer {
 public:
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    raw(&v, sizeof(T));
  }
  template <class T>
  void array(const T* data, std::size_t count) {
    value(static_cast<std::uint64_t>(count));
    raw(data, count * sizeof(T));
  }
  template <class T>
  void array(const std::vector<T>& values) {
    array(values.data(), values.size());
  }
  void raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::uint8_t> finish() {
    Hash hash;
    hash.add(bytes_);
    value(hash.value());
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), left_(size) {}

  template <class T>
  T value() {
    T v;
    raw(&v, sizeof(T));
    return v;
  }
  template <class T>
  std::vector<T> array() {
    const auto count = value<std::uint64_t>();
    require(count <= left_ / sizeof(T), "the bytes of the state are damaged: an array is longer than what is left");
    std::vector<T> values(count);
    raw(values.data(), count * sizeof(T));
    return values;
  }
  void raw(void* target, std::size_t size) {
    require(size <= left_, "the bytes of the state end too early; give all bytes that bempd_state_to_bytes() wrote");
    if (size > 0) std::memcpy(target, bytes_, size);
    bytes_ += size;
    left_ -= size;
  }
  std::size_t left() const { return left_; }

 private:
  const std::uint8_t* bytes_;
  std::size_t left_;
};

// The plain numbers of a state, so that writing and reading list them once.
template <class State, class Visit>
void visit_numbers(State& s, Visit&& visit) {
  visit(s.load_factor);
  visit(s.in_equilibrium);
  visit(s.separated);
  visit(s.events);
  visit(s.broken_bonds);
  visit(s.fragments);
  visit(s.first_unit_energy);
  visit(s.released_energy);
  visit(s.work);
  visit(s.largest_work);
  visit(s.worst_energy_balance_error);
  visit(s.residual);
  visit(s.largest_force);
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void check_header(Reader& reader) {
  char found[8];
  reader.raw(found, sizeof found);
  require(std::memcmp(found, magic, sizeof magic) == 0, "the bytes are not a state of bempd");
  const auto order = reader.value<std::uint32_t>();
  require(order == byte_order_mark, "the state was written on a machine of the other byte order");
  const auto version = reader.value<std::uint32_t>();
  require(version == format_version, "the state has format version ", version, "; this library reads version ",
          format_version);
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const SavedState& state) {
  Writer writer;
  writer.raw(magic, sizeof magic);
  writer.value(byte_order_mark);
  writer.value(format_version);
  writer.value(state.scene_fingerprint);
  writer.value(state.load_fingerprint);
  const fracture::EvolutionState& e = state.evolution;
  visit_numbers(e, [&](const auto& v) { writer.value(v); });
  writer.array(e.displacement.data(), static_cast<std::size_t>(e.displacement.size()));
  writer.array(e.total_displacement.data(), static_cast<std::size_t>(e.total_displacement.size()));
  writer.array(e.total_force.data(), static_cast<std::size_t>(e.total_force.size()));
  writer.array(e.intact);
  writer.array(e.springs);
  writer.array(e.unloaded);
  writer.array(e.history);
  writer.array(e.reactions);
  return writer.finish();
}

SavedState from_bytes(const std::uint8_t* bytes, std::size_t size) {
  Reader reader(bytes, size);
  check_header(reader);
  constexpr std::size_t checksum_size = sizeof(std::uint64_t);
  require(reader.left() > checksum_size, "the bytes of the state end too early");
  Hash hash;
  hash.add(bytes, size - checksum_size);
  std::uint64_t stored;
  std::memcpy(&stored, bytes + size - checksum_size, checksum_size);
  require(stored == hash.value(), "the bytes of the state are damaged: their checksum does not match");
  SavedState state;
  state.scene_fingerprint = reader.value<std::uint64_t>();
  state.load_fingerprint = reader.value<std::uint64_t>();
  fracture::EvolutionState& e = state.evolution;
  visit_numbers(e, [&](auto& v) { v = reader.value<std::decay_t<decltype(v)>>(); });
  const std::vector<double> displacement = reader.array<double>();
  e.displacement =
      Eigen::Map<const coupling::Affine>(displacement.data(), static_cast<Eigen::Index>(displacement.size() / 2), 2);
  e.total_displacement = vector_of(reader.array<double>());
  e.total_force = vector_of(reader.array<double>());
  e.intact = reader.array<char>();
  e.springs = reader.array<coupling::HoldingSpring>();
  e.unloaded = reader.array<char>();
  e.history = reader.array<fracture::HistoryEntry>();
  e.reactions = reader.array<double>();
  require(reader.left() == checksum_size, "the bytes of the state are damaged: something is left over");
  return state;
}

std::uint64_t Model::scene_fingerprint() const {
  Hash hash;
  const coupling::BondSet& bonds = prepared_->system->bonds();
  for (const Point& p : prepared_->discretization.positions) hash.add(p.data(), 2 * sizeof(double));
  hash.add(bonds.first);
  hash.add(bonds.second);
  hash.add(bonds.stiffness);
  hash.add(prepared_->discretization.critical_stretch);
  hash.add(prepared_->conditions.prescribed);
  hash.add(prepared_->cut_bonds);
  for (const auto& region : prepared_->discretization.regions) {
    if (const Eigen::MatrixXd* stiffness = region->stiffness())
      hash.add(stiffness->data(), static_cast<std::size_t>(stiffness->rows()) * sizeof(double));
  }
  const std::size_t supports = scene_.supports().size();
  hash.add(&supports, sizeof supports);
  return hash.value();
}

std::uint64_t Model::load_fingerprint() const {
  Hash hash;
  for (const coupling::Affine* values : {&prepared_->conditions.force, &prepared_->conditions.displacement}) {
    hash.add(values->data(), static_cast<std::size_t>(values->size()) * sizeof(double));
  }
  return hash.value();
}

SavedState Model::save() {
  if (!prepared_) fail(Failure::order, "there is no state yet; call bempd_prepare() or step first");
  // From here on the run must not depend on how the present factorization came about: a restored one has a fresh one.
  prepared_->evolution->synchronize();
  return {scene_fingerprint(), load_fingerprint(), prepared_->evolution->state()};
}

void Model::restore(const SavedState& state) {
  prepare();
  require(state.scene_fingerprint == scene_fingerprint(),
          "the state belongs to another scene; restore it into the model that was saved or one built in the same way");
  fracture::EvolutionState copy = state.evolution;
  // Loads given new values since the state was saved act on it from the next step on.
  if (state.load_fingerprint != load_fingerprint()) {
    copy.in_equilibrium = false;
    copy.first_unit_energy = -1;
  }
  prepared_->evolution->restore(std::move(copy));
  ++generation_;
}

}  // namespace bempd::model
