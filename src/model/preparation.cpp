#include "model/preparation.hpp"

#include <algorithm>
#include <map>

#include "coupling/rigid_motion.hpp"
#include "error.hpp"
#include "fracture/connectivity.hpp"
#include "geometry/outline.hpp"
#include "model/growth_options.hpp"
#include "model/line_factors.hpp"
#include "model/model.hpp"
#include "regions/crack_places.hpp"
#include "regions/fluid_paths.hpp"
#include "regions/incompressible.hpp"
#include "regions/initial_cracks.hpp"
#include "regions/shared_reactions.hpp"
#include "regions/swelling.hpp"

namespace bempd::model {

namespace {

// Whether `nodes` belong to a piece that cracks alone cut out of the inside of one region.
bool is_island(const scene::Scene& scene, const regions::Discretization& d, const std::vector<int>& nodes) {
  const auto has = [&](const std::unique_ptr<regions::Region>& region) {
    const std::vector<int>& own = region->nodes();
    const regions::CrackElements* cracks = region->crack_elements();
    return cracks && cracks->cut_the_region() && std::find(own.begin(), own.end(), nodes.front()) != own.end();
  };
  const auto region = std::find_if(d.regions.begin(), d.regions.end(), has);
  if (region == d.regions.end()) return false;
  const Outline& outline = scene.region((*region)->id()).outline();
  return std::all_of(nodes.begin(), nodes.end(), [&](int node) {
    return locate(outline, d.positions[static_cast<std::size_t>(node)], d.tolerance) == Location::inside;
  });
}

// Throws Error (argument) if a lattice in which cracks grow bond by bond has a fracture energy that depends on growth
// or direction.
void require_constant_resistance(const scene::Scene& scene) {
  for (const int id : scene.region_ids())
    require(scene.region(id).has_elements() || scene.material_of(id).resistance.is_constant(), "region ", id,
            " breaks bond by bond, which knows no resistance by growth or direction; let cracks grow as lines there "
            "(crack.rule = line or tips), or give its material no such table");
}

double extent(const std::vector<Point>& positions, const std::vector<int>& nodes) {
  double farthest = 0;
  for (const int node : nodes) farthest = std::max(farthest, (positions[node] - positions[nodes.front()]).norm());
  return farthest;
}

// Throws Error (unsolvable) for a body that can move freely. Supports on a very small part of a body prevent its
// rotation in theory only, because rounding errors are larger; the message says so.
[[noreturn]] void fail_free(const std::string& regions, const std::string& motion, double held, double size,
                            const std::string& gap) {
  constexpr double small_part = 1e-5;
  if (motion == "rotate" && held > 0 && held < small_part * size)
    fail(Failure::unsolvable, "supports hold ", regions, " along ", held, " only, of a size of ", size,
         ", which does not keep it from rotating within the digits of a number: hold it at another place as well, or "
         "make it thicker there");
  fail(Failure::unsolvable, regions, " can ", motion, gap.empty() ? "" : ": ", gap,
       gap.empty() ? "; add" : "; if not, add", " supports that prevent this, for example with bempd_fix_point()");
}

// Flags of lattice nodes on interfaces with boundary elements of the same material. A node at the end of an interface
// is only flagged if another such interface begins there.
std::vector<char> nodes_where_material_goes_on(const scene::Scene& scene, const regions::Discretization& d) {
  constexpr int on_interface = 2, at_its_end = 1;
  std::vector<int> found(d.positions.size(), 0);
  for (const Contact& c : d.arrangement.contacts) {
    const int id = c.region + 1, other = c.other_region + 1;
    if (scene.region(id).has_elements() || !scene.region(other).has_elements()) continue;
    if (!(scene.material_of(id) == scene.material_of(other))) continue;
    const regions::EdgeSpan span{c.edge + 1, scene.region(id).edge(c.edge + 1), c.from, c.to};
    for (const regions::PlacedNode& node : d.region(id).loads().nodes_on(span, d.tolerance)) {
      const bool at_end = std::min(node.fraction, 1 - node.fraction) < 1e-9;
      found[static_cast<std::size_t>(node.node)] += at_end ? at_its_end : on_interface;
    }
  }
  std::vector<char> goes_on;
  for (const int count : found) goes_on.push_back(count >= on_interface ? 1 : 0);
  return goes_on;
}

// Tips of initial cracks in lattices, each with the number of its growth law.
std::vector<fracture::GrowingTip> first_tips(const scene::Scene& scene, const scene::Options& options,
                                             const PreparedScene& p, const std::map<int, int>& law_of_region) {
  std::vector<fracture::GrowingTip> tips;
  for (const regions::StartingTip& tip : regions::tips_of_cracks(scene, p.in_lattices, p.discretization, options)) {
    tips.push_back({tip.place, tip.direction, law_of_region.at(tip.region), tip.id});
    tips.back().even_ahead = tip.even_ahead;
    tips.back().grown = scene.cracks()[static_cast<std::size_t>(tip.id.crack) - 1].grown(tip.id.end);
  }
  return tips;
}

// Throws Error (unsolvable) if a part of the body can move freely.
void check_mechanism(const scene::Scene& scene, const PreparedScene& p) {
  const std::vector<Point>& positions = p.discretization.positions;
  for (const std::vector<int>& nodes : fracture::Connectivity(*p.system).pieces()) {
    std::vector<int> held;
    for (const coupling::HeldDirection& h : held_directions(p, nodes)) held.push_back(h.node);
    const coupling::RigidMotion motion(positions, nodes, held_directions(p, nodes));
    if (motion.free_count() == 0 || is_island(scene, p.discretization, nodes)) continue;
    fail_free(p.discretization.regions_with(nodes), motion.describe(), extent(positions, held),
              extent(positions, nodes), p.discretization.gap);
  }
}

fracture::ContactPlan contact_plan(const scene::Options& options, const PreparedScene& p) {
  if (options.text_value("contact") == "none" || options.text_value("scheme") != "symmetric") return {};
  pd::FacePlaces lattices = regions::face_lattices(p.discretization);
  if (lattices.lattice_count() == 0) return {};
  std::vector<pd::FacePlace> places = regions::places_on_cracks(p.in_lattices.cracks, p.discretization, lattices);
  return {true, std::move(lattices), std::move(places)};
}

void add_crack_fluid(const scene::Scene& scene, PreparedScene& p) {
  if (p.conditions.crack_pressures.empty()) return;
  std::map<int, std::vector<int>> cut;
  for (const regions::CrackPressure& pressure : p.conditions.crack_pressures) {
    std::vector<std::string> told_before;
    std::vector<int>& bonds = cut[pressure.crack];
    if (!bonds.empty()) continue;
    const scene::Crack& crack = p.in_lattices.cracks[static_cast<std::size_t>(pressure.crack) - 1];
    for (const auto& region : p.discretization.regions)
      if (const regions::RegionBonds* own = region->bonds()) own->cut(crack, pressure.crack, bonds, told_before);
  }
  const coupling::Terms& terms = p.system->terms();
  p.evolution->add_crack_fluid({regions::fluid_paths(scene, p.discretization, terms, p.in_lattices.weakened),
                                std::move(cut), terms, p.discretization.positions});
}

}  // namespace

fracture::CrackPressures pressures_of(const regions::DofConditions& conditions) {
  fracture::CrackPressures sums;
  for (const regions::CrackPressure& pressure : conditions.crack_pressures) {
    sums.try_emplace(pressure.crack, Eigen::RowVector2d::Zero());
    sums[pressure.crack] += pressure.value;
  }
  return sums;
}

// Prepares crack lines (cracks that grow in lattices by steps): laws of growth and initial tips. If cracks grow bond by
// bond, nothing is done.
void Preparation::grow_lines(PreparedScene& p) const {
  const scene::Options& options = model_.options();
  const std::string rule = options.text_in_effect("crack.rule");
  if (rule == "bond") return require_constant_resistance(scene_);
  pd::TipLaws laws;
  laws.more_begin = rule != "tips";
  laws.criterion = growth_criterion(options);
  laws.loads_by_energy = options.text_value("crack.load") == "energy";
  laws.of_node.assign(p.discretization.positions.size(), -1);
  laws.share_of_node.assign(laws.of_node.size(), 0);
  laws.joined = nodes_where_material_goes_on(scene_, p.discretization);
  std::map<int, int> law_of_region;
  for (const auto& region : p.discretization.regions) {
    if (!region->bonds()) continue;
    const std::optional<pd::TipLaw> law = region->bonds()->tip_law(options);
    if (!law) continue;
    law_of_region[region->id()] = static_cast<int>(laws.laws.size());
    const std::vector<double> shares = region->bonds()->cell_shares();
    for (std::size_t k = 0; k < region->nodes().size(); ++k) {
      const auto node = static_cast<std::size_t>(region->nodes()[k]);
      laws.of_node[node] = static_cast<int>(laws.laws.size());
      if (k < shares.size()) laws.share_of_node[node] += shares[k];
    }
    laws.laws.push_back(*law);
    if (law->energies) {
      laws.energy_share_of_node.resize(laws.of_node.size(), 1);
      for (const int node : region->nodes())
        laws.energy_share_of_node[static_cast<std::size_t>(node)] =
            law->energies->share(p.discretization.positions[static_cast<std::size_t>(node)]);
    }
    const Outline& outline = scene_.region(region->id()).outline();
    for (std::size_t k = 0; const Edge& edge : edges_of(outline))
      (k++ < outline.loops.front().size() ? laws.outer_edges : laws.hole_edges).push_back(edge);
  }
  std::vector<fracture::GrowingTip> tips = first_tips(scene_, options, p, law_of_region);
  laws.of_crack = regions::lengths_of(p.in_lattices);
  laws.weakened = p.in_lattices.weakened;
  p.first_tips = tips.size(), p.tip_laws = laws.laws.size();
  p.evolution->grow_lines(
      std::move(laws), std::move(tips),
      [this](int crack, const std::vector<double>& fractions) {
        return model_.cracks().openings_in_lattices(crack, fractions);
      },
      [this, &p](const auto& tip, const auto& displacement) {
        return factors_around(scene_, model_.options(), p, tip, displacement);
      });
}

std::unique_ptr<PreparedScene> Preparation::build(const PreparedScene* before, Operators operators) const {
  const scene::Options& options = model_.options();
  const PreparedScene* const lender = operators == Operators::kept ? before : nullptr;
  auto p = std::make_unique<PreparedScene>();
  p->fingerprint = before ? before->fingerprint : fingerprint(scene_, options);
  p->discretization = regions::discretize(scene_, options, lender ? &lender->discretization : nullptr);
  regions::Discretization& d = p->discretization;
  p->conditions = regions::apply_conditions(scene_, d);
  regions::swell(d, p->conditions.swelling);
  regions::require_determined_pressure(d, p->conditions.prescribed);
  p->in_lattices = regions::cracks_in_lattices(scene_, d, options);
  for (const pd::WeakenedTerm& weak : p->in_lattices.weakened)
    d.bonds.stiffness[static_cast<std::size_t>(weak.term)] *= weak.share;
  d.warnings.insert(d.warnings.end(), p->in_lattices.warnings.begin(), p->in_lattices.warnings.end());
  p->cut_bonds = regions::bonds_cut_by_cracks(p->in_lattices.cracks, d, d.warnings);
  p->system = std::make_unique<coupling::EquilibriumSystem>(static_cast<int>(d.positions.size()), d.dense_operators(),
                                                            std::move(d.bonds), p->conditions.prescribed, d.ties);
  if (lender) p->system->take_over(*lender->system);
  p->system->note_condition(regions::condition_of_held_pressure(scene_, d, p->conditions.prescribed, d.warnings));
  if (!before) check_mechanism(scene_, *p);  // parts that growth has cut off are held
  if (before) check_loads_inside_free_pieces(*p);
  p->evolution = std::make_unique<fracture::CrackEvolution>(*p->system, d.positions, d.critical_stretch, p->cut_bonds,
                                                            regions::dofs_of_supports(scene_, d, p->conditions),
                                                            contact_plan(options, *p));
  grow_lines(*p);
  add_crack_fluid(scene_, *p);
  p->evolution->loads().load_faces(p->conditions.face_offsets);
  p->evolution->loads().set(p->conditions.force, p->conditions.displacement, p->conditions.work_within,
                            pressures_of(p->conditions));
  p->interface_bonds.emplace(*p->system, d.positions);
  return p;
}

}  // namespace bempd::model
