#include "model/model.hpp"
#include "results/history_table.hpp"
#include "results/names_picture.hpp"
#include "results/tip_table.hpp"

// Output files of a model.
namespace bempd::model {

void Model::write_snapshot(const std::string& prefix) {
  ensure_equilibrium();
  const results::CracksShown cracks{crack_pictures(), records_tips() ? tips() : std::vector<regions::TipValues>()};
  std::vector<results::PicturePart> parts = results::pictures(
      scene_, prepared_->discretization, solution(), results_.fields(), cracks, options_.number("snapshots.inside"));
  results::add_names(parts, scene_, names_);
  snapshots_.write(prefix, {load_factor(), prepared_->evolution->progress().events}, std::move(parts), options_);
}

void Model::write_history(const std::string& path) const {
  std::vector<results::SupportColumns> supports;
  for (const scene::Condition& support : scene_.supports())
    supports.push_back(
        {!support.removed(), names_.of(scene::Names::Kind::support, static_cast<int>(supports.size()) + 1)});
  results::write_history(path, prepared_ ? &prepared_->evolution->progress() : nullptr, supports);
}

void Model::write_tips(const std::string& path) const { results::write_tips(path, tip_history_); }

}  // namespace bempd::model
