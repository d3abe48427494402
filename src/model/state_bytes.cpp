#include <algorithm>
#include <cstring>
#include <type_traits>

#include "error.hpp"
#include "hash.hpp"
#include "model/state_checks.hpp"
#include "model/state_members.hpp"

namespace bempd::model {

namespace {

constexpr char magic[8] = {'B', 'E', 'M', 'P', 'D', 'S', 'T', '\0'};
constexpr std::uint32_t byte_order_mark = 0x01020304;

// Form in which the values of a support or load are written: samples along an edge, or values at places. For a function
// of the host no values are written.
enum class Form : std::uint8_t { function, samples, places };

// Writes structs number by number, because the padding between their members is undefined.
class Writer {
 public:
  static constexpr int format = state_format;
  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(const T& number) { raw(&number, sizeof number); }
  void operator()(const bool& flag) { (*this)(static_cast<std::uint8_t>(flag)); }
  template <class T>
  void operator()(const T& member, Allowed) {
    (*this)(member);
  }
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
  int format = state_format;  // format of the bytes
  Reader(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), left_(size) {}

  template <class T>
  requires std::is_arithmetic_v<T>
  void operator()(T& number) { raw(&number, sizeof number); }
  template <class T>
  void operator()(T& member, Allowed) {
    (*this)(member);
  }
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
        values.emplace<scene::BoundaryFunction>();  // unknown function
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
    // The number of entries is limited by the number of bytes left (no entry is shorter than its smallest number), so
    // that damaged bytes cannot request much memory.
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
  // Optional lists, written up to the last one that is not empty.
  const std::vector<std::int64_t>& layouts = state.evolution.layouts;
  if (!state.frozen.empty() || !state.overloads.empty() || !layouts.empty()) writer(state.frozen);
  if (!state.overloads.empty() || !layouts.empty()) writer(state.overloads);
  if (!layouts.empty()) writer(layouts);
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
  if (reader.left() > sizeof stored) reader(state.evolution.layouts);
  require(reader.left() == sizeof stored, "the bytes of the state are damaged: something is left over");
  require_consistent(state);
  return state;
}

}  // namespace bempd::model
