#include <algorithm>
#include <cmath>
#include <limits>

#include "elasticity/kinked_tip.hpp"
#include "error.hpp"
#include "geometry/turning.hpp"
#include "model/crack_way.hpp"
#include "model/model.hpp"

namespace bempd::model {

// The tips that grow at a load factor, each with its extension, and how long that is to be.
struct Growing {
  double load_factor = 0;
  std::vector<regions::TipValues> tips;
  std::vector<fracture::CrackExtension> extensions;
  std::vector<double> lengths;
};

namespace {

constexpr int most_rounds_of_faces = 64;

KinkCriterion criterion_of(const scene::Options& options) {
  return options.text_value("growth.criterion") == "energy" ? KinkCriterion::energy_release_rate
                                                            : KinkCriterion::hoop_stress;
}

Kink kink_at(const regions::TipValues& tip, double load_factor, KinkCriterion criterion) {
  return kink_of(tip.constant_factors + load_factor * tip.proportional_factors, criterion);
}

Growing growing_tips(const std::vector<regions::TipValues>& tips, double length, const scene::Options& options) {
  const KinkCriterion criterion = criterion_of(options);
  std::vector<double> load_factors;
  load_factors.reserve(tips.size());
  for (const regions::TipValues& tip : tips)
    load_factors.push_back(
        growth_load_factor(tip.constant_factors, tip.proportional_factors, tip.toughness, criterion));
  Growing growing;
  growing.load_factor = *std::min_element(load_factors.begin(), load_factors.end());
  if (!std::isfinite(growing.load_factor))
    fail(Failure::unsolvable,
         "no crack grows however large the load factor is; give their materials a fracture_energy, "
         "and loads that open them");
  const double share = options.number("growth.share"), exponent = options.number("growth.exponent");
  for (std::size_t t = 0; t < tips.size(); ++t) {
    if (!(load_factors[t] <= (1 + share) * growing.load_factor)) continue;
    const regions::TipValues& tip = tips[t];
    const Kink kink = kink_at(tip, growing.load_factor, criterion);
    fracture::CrackExtension extension;
    extension.crack = tip.crack;
    extension.end = tip.end;
    extension.angle = kink.angle;
    extension.load_factor = growing.load_factor;
    extension.rate_before = kink.equivalent_factor * kink.equivalent_factor / tip.plane_modulus;
    growing.tips.push_back(tip);
    growing.extensions.push_back(extension);
    growing.lengths.push_back(length * std::pow(kink.equivalent_factor / tip.toughness, 2 * exponent));
  }
  return growing;
}

// One after another, so that two that run into each other meet.
std::vector<scene::Crack> extended(const scene::Scene& scene, std::vector<scene::Crack> cracks, double tolerance,
                                   Growing& growing) {
  for (std::size_t k = 0; k < growing.tips.size(); ++k) {
    fracture::CrackExtension& e = growing.extensions[k];
    const Point& from = growing.tips[k].place;
    const TipWay way = way_of_tip(scene, cracks, e.crack, e.end, turned(growing.tips[k].direction, e.angle),
                                  growing.lengths[k], tolerance);
    scene::Crack& crack = cracks[static_cast<std::size_t>(e.crack) - 1];
    extend(crack, e.end, way.to);
    e.ended = way.ends;
    e.x = way.to.x();
    e.y = way.to.y();
    e.length = (way.to - from).norm();
    e.crack_length = length_of(crack);
  }
  return cracks;
}

const regions::TipValues* tip_of(const fracture::CrackExtension& e, const std::vector<regions::TipValues>& tips) {
  const auto found =
      std::find_if(tips.begin(), tips.end(), [&](const auto& tip) { return tip.crack == e.crack && tip.end == e.end; });
  return found == tips.end() ? nullptr : &*found;
}

// Of a curved path the chord's end turns on by as much as its start has turned. Says whether any does.
bool turn_to_chords(Growing& growing, const std::vector<regions::TipValues>& after, const scene::Options& options) {
  bool any = false;
  for (fracture::CrackExtension& e : growing.extensions) {
    const regions::TipValues* tip = tip_of(e, after);
    if (e.ended || !tip) continue;
    e.angle += 0.5 * kink_at(*tip, e.load_factor, criterion_of(options)).angle;
    any = true;
  }
  return any;
}

// By extension.
std::vector<double> thickness_at(const scene::Scene& scene, const PreparedScene& prepared,
                                 const std::vector<fracture::CrackExtension>& extensions) {
  std::vector<double> thickness;
  for (const fracture::CrackExtension& e : extensions) {
    const int region = prepared.discretization.crack_regions[static_cast<std::size_t>(e.crack) - 1];
    thickness.push_back(scene.material_of(region).elasticity.thickness);
  }
  return thickness;
}

// The energy that each took: the integral of its rate; what others leave where it has ended, for the rate on the way to
// an edge is not known.
GrowthResult share_energy(std::vector<fracture::CrackExtension>& extensions,
                          const std::vector<regions::TipValues>& after, const std::vector<double>& thickness,
                          double released) {
  GrowthResult result{static_cast<int>(extensions.size()), 0, extensions.front().load_factor, 0, released};
  double left = released, ended_length = 0;
  for (std::size_t k = 0; k < extensions.size(); ++k) {
    fracture::CrackExtension& e = extensions[k];
    result.length += e.length;
    result.ended += e.ended;
    if (const regions::TipValues* tip = tip_of(e, after)) {
      e.rate_after = tip->energy_release_rate;
      e.released_energy = 0.5 * (e.rate_before + e.rate_after) * e.length * thickness[k];
      left -= e.released_energy;
    } else {
      ended_length += e.length;
    }
  }
  for (fracture::CrackExtension& e : extensions)
    if (!tip_of(e, after)) e.released_energy = left * e.length / ended_length;
  return result;
}

}  // namespace

void Model::set_tip_frozen(int crack, int end, bool frozen) {
  scene_.crack(crack);
  if (frozen) {
    frozen_tips_.insert({crack, end});
  } else {
    frozen_tips_.erase({crack, end});
  }
}

std::span<const fracture::CrackExtension> Model::extensions() const {
  if (!prepared_) return {};
  return prepared_->evolution->progress().extensions;
}

// Those that may grow, with the load factors at which they do.
std::vector<regions::TipValues> Model::free_tips() {
  prepare();
  if (loads_.acting != Acting::values) act_as_said();
  ensure_equilibrium();
  require(prepared_->system->terms().size() == 0,
          "the scene has peridynamic regions, whose cracks grow by steps; cracks grow by lengths where all regions are "
          "BEM regions");
  if (factors_generation_ != generation_) tip_factors_ = tips_of(*prepared_, regions::TipDetail::factors);
  factors_generation_ = generation_;
  std::vector<regions::TipValues> tips = tip_factors_;
  require(!tips.empty(),
          "no crack in a BEM region has a tip; add one, or let cracks in peridynamic regions grow by steps");
  std::erase_if(tips, [&](const auto& tip) { return frozen_tips_.count({tip.crack, tip.end}) > 0; });
  require(!tips.empty(), "all tips are frozen; let one grow again with bempd_set_tip_frozen()");
  return tips;
}

// To where the first tips are critical. Faces that close or open on the way make other tips of them.
Growing Model::go_to_growth(double length) {
  Growing growing = growing_tips(free_tips(), length, options_);
  for (int round = 0; load_factor() != growing.load_factor; ++round) {
    if (round == most_rounds_of_faces)
      fail(Failure::convergence, "faces of cracks close and open without an end where cracks are to grow");
    const std::int64_t switches = prepared_->evolution->progress().contact_switches;
    prepared_->evolution->advance(growing.load_factor, fracture::Goal::load_factor, {}, {}, {});
    if (prepared_->evolution->progress().contact_switches == switches) break;
    ++generation_;
    growing = growing_tips(free_tips(), length, options_);
  }
  return growing;
}

GrowthResult Model::grow_cracks(double length) {
  require(std::isfinite(length) && length > 0, "length is ", length, "; it must be > 0");
  growing_tips(free_tips(), length, options_);  // throws before anything is done
  std::vector<scene::Crack> before = scene_.cracks();
  fracture::EvolutionState state = prepared_->evolution->state();
  const auto recorded = static_cast<std::ptrdiff_t>(tip_history_.size());
  GrowthResult result;
  std::unique_ptr<PreparedScene> next;  // once the longer cracks are in place: the shorter ones
  bool in_place = false;
  try {
    Growing growing = go_to_growth(length);
    next = extended_scene(before, growing);
    if (options_.text_value("growth.direction") == "chord" &&
        turn_to_chords(growing, tips_of(*next, regions::TipDetail::factors), options_)) {
      next = extended_scene(before, growing);
    }
    tip_factors_ = tips_of(*next, regions::TipDetail::factors);
    result =
        share_energy(growing.extensions, tip_factors_, thickness_at(scene_, *next, growing.extensions),
                     next->evolution->progress().released_energy - prepared_->evolution->progress().released_energy);
    next->evolution->book(growing.extensions);
    scene::SceneValues in_force = scene_.values();
    prepared_.swap(next), in_place = true;
    ++generation_;
    if (records_tips()) record_tips();
    loads_.in_force = std::move(in_force);
    factors_generation_ = generation_;
  } catch (...) {
    if (in_place) prepared_.swap(next);
    tip_history_.erase(tip_history_.begin() + recorded, tip_history_.end());
    scene_.set_cracks(std::move(before));
    prepared_->evolution->restore(std::move(state));
    ++generation_;
    throw;
  }
  say([&] {
    for (const std::string& warning : prepared_->discretization.warnings) log(1, warning);
    log(2, text("load factor ", result.load_factor, ": ", result.tips, " tips have grown by ", result.length));
    warn_of_equilibrium();
  });
  return result;
}

// Built beside the present one, whose run it goes on with.
std::unique_ptr<PreparedScene> Model::extended_scene(const std::vector<scene::Crack>& before, Growing& growing) {
  scene_.set_cracks(extended(scene_, before, prepared_->discretization.tolerance, growing));
  std::unique_ptr<PreparedScene> next = build(prepared_.get());
  next->evolution->go_on_after_growth(*prepared_->evolution);
  return next;
}

// Grown again event by event, so that what regions take over from the scene before has the same digits.
std::unique_ptr<PreparedScene> Model::as_grown(const std::vector<fracture::CrackExtension>& extensions) {
  const auto place = [](const fracture::CrackExtension& e) { return std::tuple(e.crack, e.end, e.x, e.y); };
  const auto same = [&](const auto& a, const auto& b) { return place(a) == place(b); };
  const std::span<const fracture::CrackExtension> present = this->extensions();
  if (std::equal(present.begin(), present.end(), extensions.begin(), extensions.end(), same)) return nullptr;
  std::vector<scene::Crack> cracks;
  for (const scene::Crack& crack : scene_.cracks())
    cracks.push_back({{crack.given().begin(), crack.given().end()}, 0, 0});
  scene_.set_cracks(cracks);
  std::unique_ptr<PreparedScene> grown = build(nullptr);
  for (std::size_t k = 0; k < extensions.size(); ++k) {
    const fracture::CrackExtension& e = extensions[k];
    require(e.crack <= static_cast<int>(cracks.size()) && !cracks[static_cast<std::size_t>(e.crack) - 1].points.empty(),
            "the state's extensions are of crack ", e.crack, ", which the scene does not have; its bytes were altered");
    extend(cracks[static_cast<std::size_t>(e.crack) - 1], e.end, {e.x, e.y});
    if (k + 1 < extensions.size() && extensions[k + 1].event == e.event) continue;
    scene_.set_cracks(cracks);
    grown = build(grown.get());
  }
  return grown;
}

}  // namespace bempd::model
