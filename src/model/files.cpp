#include "model/model.hpp"
#include "results/history_table.hpp"
#include "results/names_picture.hpp"
#include "results/tip_table.hpp"

namespace bempd::model {

void ResultFiles::write_snapshot(const std::string& prefix) {
  const PreparedScene& prepared = model_.in_equilibrium();
  const scene::Options& options = model_.options();
  CrackResults& cracks = model_.cracks();
  const results::CracksShown shown{cracks.pictures(),
                                   cracks.are_recorded() ? cracks.tips() : std::vector<regions::TipValues>()};
  std::vector<results::PicturePart> parts =
      results::pictures(model_.scene(), prepared.discretization, solution_of(prepared), model_.results().fields(),
                        shown, options.number("snapshots.inside"));
  results::add_names(parts, model_.scene(), model_.names());
  snapshots_.write(prefix, {model_.load_factor(), prepared.evolution->progress().events}, std::move(parts), options);
}

void ResultFiles::write_history(const std::string& path) const {
  std::vector<results::SupportColumns> supports;
  for (const scene::Condition& support : model_.scene().supports())
    supports.push_back(
        {!support.removed(), model_.names().of(scene::Names::Kind::support, static_cast<int>(supports.size()) + 1)});
  const PreparedScene* prepared = model_.prepared_or_null();
  results::write_history(path, prepared ? &prepared->evolution->progress() : nullptr, supports);
}

void ResultFiles::write_tips(const std::string& path) const { results::write_tips(path, model_.cracks().history()); }

}  // namespace bempd::model
