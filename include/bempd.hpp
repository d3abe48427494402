/**
 * @file bempd.hpp
 * @brief bempd.h for hosts in C++17: models that free themselves, exceptions, arrays with their length.
 *
 * Model has methods for what most hosts use. Every other function of bempd.h is called through two templates:
 * `model.call(bempd_set_edge_arc, region, edge, x, y)` throws if the function fails, and
 * `model.ask(bempd_crack_length, crack)` returns what the function writes to its last argument. Points and Numbers
 * stand for a count and a pointer in both: `model.ask(bempd_add_hole, region, bempd::Points{{1, 1}, {1, 2}, {2, 2}})`.
 * The header needs nothing but the C header and the library: no part of it is compiled into the library.
 */
#ifndef BEMPD_HPP
#define BEMPD_HPP

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#if __has_include(<version>)
#include <version>
#endif
#if defined(__cpp_lib_span)
#include <span>
#endif

#include "bempd.h"

namespace bempd {

/** A call that failed; what() is the library's sentence. */
class Error : public std::runtime_error {
 public:
  Error(bempd_status status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
  bempd_status status() const noexcept { return status_; }

 private:
  bempd_status status_;
};

inline void check(bempd_status status, const bempd_model* model = nullptr) {
  if (status != BEMPD_OK) throw Error(status, bempd_last_error(model));
}

inline bempd_status initialize(bempd_material* s) { return bempd_material_init(s, sizeof *s); }
inline bempd_status initialize(bempd_option_info* s) { return bempd_option_info_init(s, sizeof *s); }
inline bempd_status initialize(bempd_step_report* s) { return bempd_step_report_init(s, sizeof *s); }
inline bempd_status initialize(bempd_piece* s) { return bempd_piece_init(s, sizeof *s); }
inline bempd_status initialize(bempd_singularity* s) { return bempd_singularity_init(s, sizeof *s); }
inline bempd_status initialize(bempd_crack_tip* s) { return bempd_crack_tip_init(s, sizeof *s); }
inline bempd_status initialize(bempd_path_vertex* s) { return bempd_path_vertex_init(s, sizeof *s); }
inline bempd_status initialize(bempd_growth* s) { return bempd_growth_init(s, sizeof *s); }
inline bempd_status initialize(bempd_crack_extension* s) { return bempd_crack_extension_init(s, sizeof *s); }
inline bempd_status initialize(bempd_statistics* s) { return bempd_statistics_init(s, sizeof *s); }
inline bempd_status initialize(bempd_history_entry* s) { return bempd_history_entry_init(s, sizeof *s); }

/** A struct of bempd.h with its size and defaults: `auto steel = bempd::make<bempd_material>()`. Numbers are 0. */
template <class Value>
Value make() {
  Value value{};
  if constexpr (std::is_class_v<Value>) check(initialize(&value));
  return value;
}

/** Numbers or points that a function takes as a count and a pointer; they must live as long as the call.
 * They come from a pointer and a count, a list in braces, or what has data() and size(): std::vector, std::array,
 * std::span. */
template <int components>
class Array {
 public:
  using Entry = std::conditional_t<components == 1, double, std::array<double, 2>>;

  Array(const double* data, std::int64_t count) : data_(data), count_(count) {}
  Array(std::initializer_list<Entry> entries) : own_(entries), count_(static_cast<std::int64_t>(own_.size())) {
    data_ = reinterpret_cast<const double*>(own_.data());
  }
  /** A range of entries; points may also be a range of x, y, x, y, ... */
  template <class Range,
            class Value = std::remove_cv_t<std::remove_pointer_t<decltype(std::data(std::declval<const Range&>()))>>,
            class = std::enable_if_t<std::is_same_v<std::remove_cv_t<Value>, double> ||
                                     std::is_same_v<std::remove_cv_t<Value>, Entry>>>
  Array(const Range& range) : data_(reinterpret_cast<const double*>(std::data(range))) {
    constexpr std::size_t numbers = std::is_same_v<Value, double> ? components : 1;
    if (std::size(range) % numbers != 0)
      throw std::invalid_argument("bempd::Points: an odd number of coordinates is given");
    count_ = static_cast<std::int64_t>(std::size(range) / numbers);
  }
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;

  const double* data() const noexcept { return data_; }
  std::int64_t count() const noexcept { return count_; }

 private:
  std::vector<Entry> own_;
  const double* data_ = nullptr;
  std::int64_t count_ = 0;
};
using Numbers = Array<1>;
using Points = Array<2>;

#if defined(__cpp_lib_span)
using View = std::span<const double>;
#else
/** The library's numbers, read-only, as std::span<const double> of C++20. */
class View {
 public:
  View() = default;
  View(const double* data, std::size_t size) : data_(data), size_(size) {}
  const double* data() const noexcept { return data_; }
  std::size_t size() const noexcept { return size_; }
  const double* begin() const noexcept { return data_; }
  const double* end() const noexcept { return data_ + size_; }
  const double& operator[](std::size_t index) const noexcept { return data_[index]; }

 private:
  const double* data_ = nullptr;
  std::size_t size_ = 0;
};
#endif

/** A field of a region: `components` numbers for each node; valid until the model changes. */
struct Field {
  View values;
  std::int32_t components = 0;
};

/** A saved state of a model. */
class State {
 public:
  explicit State(bempd_state* state) : state_(state) {}
  const bempd_state* get() const noexcept { return state_.get(); }

 private:
  struct Free {
    void operator()(bempd_state* state) const noexcept { bempd_state_free(state); }
  };
  std::unique_ptr<bempd_state, Free> state_;
};

/** A scene and its state; it is freed with the object, moved and not copied. */
class Model {
 public:
  Model() {
    bempd_model* created = nullptr;
    check(bempd_model_create(&created));
    model_.reset(created);
  }
  bempd_model* get() const noexcept { return model_.get(); }

  /** Call any function of bempd.h on the model. */
  template <class Handle, class... Parameters, class... Arguments>
  void call(bempd_status (*function)(Handle*, Parameters...), const Arguments&... arguments) const {
    static_assert(std::is_same_v<std::remove_const_t<Handle>, bempd_model>, "the function has to take a model first");
    const auto all = std::tuple_cat(expanded(arguments)...);
    const bempd_status status = std::apply([&](auto... each) { return function(model_.get(), each...); }, all);
    if (hooks_ && hooks_->raised) std::rethrow_exception(std::exchange(hooks_->raised, nullptr));
    check(status, model_.get());
  }
  /** Call a function whose last argument is where it writes its result; returns that. */
  template <class Handle, class... Parameters, class... Arguments>
  auto ask(bempd_status (*function)(Handle*, Parameters...), const Arguments&... arguments) const {
    using Last = std::tuple_element_t<sizeof...(Parameters) - 1, std::tuple<Parameters...>>;
    static_assert(std::is_pointer_v<Last> && !std::is_const_v<std::remove_pointer_t<Last>>,
                  "the function has no result");
    auto result = make<std::remove_pointer_t<Last>>();
    call(function, arguments..., &result);
    return result;
  }

  void set_option(const char* name, double value) { call(bempd_set_option, name, value); }
  void set_option(const char* name, const char* value) { call(bempd_set_option_text, name, value); }

  std::int32_t add_material(const bempd_material& material) { return ask(bempd_add_material, &material); }
  std::int32_t add_body(std::int32_t material, const Points& vertices) {
    return ask(bempd_add_body, material, vertices);
  }
  std::int32_t add_bem_region(std::int32_t material, const Points& vertices, double element_length) {
    return ask(bempd_add_bem_region, material, vertices, element_length);
  }
  std::int32_t add_pd_region(std::int32_t material, const Points& vertices, double spacing,
                             std::int32_t horizon_ratio = 0) {
    return ask(bempd_add_pd_region, material, vertices, spacing, horizon_ratio);
  }
  /** Number of the first of its four edges. */
  std::int32_t add_circular_hole(std::int32_t region, double x, double y, double radius) {
    return ask(bempd_add_circular_hole, region, x, y, radius);
  }
  std::int32_t add_crack(const Points& points) { return ask(bempd_add_crack, points); }
  std::int32_t fix_edge(std::int32_t region, std::int32_t edge, std::int32_t component = BEMPD_BOTH) {
    return ask(bempd_fix_edge, region, edge, component);
  }
  std::int32_t fix_point(double x, double y, std::int32_t component = BEMPD_BOTH) {
    return ask(bempd_fix_point, x, y, component);
  }
  /** Displacement [m] of a whole edge: constant + load_factor * proportional. */
  std::int32_t prescribe_edge(std::int32_t region, std::int32_t edge, std::int32_t component, double proportional,
                              double constant = 0) {
    return ask(bempd_prescribe_edge, region, edge, 0.0, 1.0, component, std::int64_t{1}, &constant, &proportional);
  }
  /** Traction [Pa] on a whole edge: constant + load_factor * proportional. */
  std::int32_t add_traction(std::int32_t region, std::int32_t edge, std::int32_t component, double proportional,
                            double constant = 0) {
    return ask(bempd_add_traction, region, edge, 0.0, 1.0, component, std::int64_t{1}, &constant, &proportional);
  }

  bempd_step_report step(double load_factor) { return ask(bempd_step, load_factor); }
  bempd_step_report step_to_next_event(double limit) { return ask(bempd_step_to_next_event, limit); }
  bempd_step_report run_to_separation(double limit) { return ask(bempd_run_to_separation, limit); }

  double load_factor() const { return ask(bempd_load_factor); }
  /** Force [N] that a support exerts on the body. */
  std::array<double, 2> reaction(std::int32_t support) const {
    std::array<double, 2> force{};
    call(bempd_reaction, support, force.data());
    return force;
  }
  Field field(std::int32_t region, std::int32_t field) const {
    const double* values = nullptr;
    std::int64_t count = 0, generation = 0;
    Field result;
    call(bempd_view_field, region, field, &values, &count, &result.components, &generation);
    result.values = View(values, static_cast<std::size_t>(count * result.components));
    return result;
  }
  std::vector<bempd_crack_tip> tips() const {
    std::vector<bempd_crack_tip> found(static_cast<std::size_t>(ask(bempd_tip_count)));
    for (std::size_t k = 0; k < found.size(); ++k) found[k] = ask(bempd_tip, static_cast<std::int64_t>(k));
    return found;
  }
  State save() const { return State(ask(bempd_state_save)); }
  void restore(const State& state) { call(bempd_state_restore, state.get()); }

  /** Be told (load factor, events, broken bonds) after every event; an exception cancels the step and leaves it. */
  void on_progress(std::function<void(double, std::int64_t, std::int64_t)> function) {
    hooks().progress = std::move(function);
    call(bempd_set_progress, hooks().progress ? &told_of_progress : nullptr, static_cast<void*>(hooks_.get()));
  }
  /** Receive the log: level 1 warning, 2 information, 3 detail. */
  void on_log(std::function<void(std::int32_t, const char*)> function) {
    hooks().log = std::move(function);
    call(bempd_set_log, hooks().log ? &told_of_log : nullptr, static_cast<void*>(hooks_.get()));
  }

 private:
  struct Free {
    void operator()(bempd_model* model) const noexcept { bempd_model_free(model); }
  };
  struct Hooks {
    bempd_model* model = nullptr;
    std::function<void(double, std::int64_t, std::int64_t)> progress;
    std::function<void(std::int32_t, const char*)> log;
    std::exception_ptr raised;
  };

  template <class Argument>
  static auto expanded(const Argument& argument) {
    if constexpr (std::is_same_v<Argument, Numbers> || std::is_same_v<Argument, Points>) {
      return std::make_tuple(argument.count(), argument.data());
    } else {
      return std::make_tuple(argument);
    }
  }
  static std::int32_t told_of_progress(double load_factor, std::int64_t events, std::int64_t broken_bonds, void* user) {
    Hooks& hooks = *static_cast<Hooks*>(user);
    try {
      hooks.progress(load_factor, events, broken_bonds);
      return 0;
    } catch (...) {
      hooks.raised = std::current_exception();
      return 1;
    }
  }
  static void told_of_log(std::int32_t level, const char* message, void* user) {
    Hooks& hooks = *static_cast<Hooks*>(user);
    try {
      hooks.log(level, message);
    } catch (...) {
      hooks.raised = std::current_exception();
      bempd_request_cancel(hooks.model);
    }
  }
  Hooks& hooks() {
    if (!hooks_) hooks_ = std::make_unique<Hooks>();
    hooks_->model = model_.get();
    return *hooks_;
  }

  std::unique_ptr<Hooks> hooks_;  // lives longer than the model, which calls it
  std::unique_ptr<bempd_model, Free> model_;
};

}  // namespace bempd

#endif
