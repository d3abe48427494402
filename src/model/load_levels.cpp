#include "model/load_levels.hpp"

#include <algorithm>

namespace bempd::model {

LoadLevels::LoadLevels(const std::vector<LoadBlock>& blocks) {
  for (const LoadBlock& block : blocks) levels_.push_back(block.high), levels_.push_back(block.low);
  std::sort(levels_.begin(), levels_.end(), [](const LoadLevel& a, const LoadLevel& b) { return a < b; });
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  const auto number = [&](const LoadLevel& level) {
    return static_cast<std::size_t>(std::find(levels_.begin(), levels_.end(), level) - levels_.begin());
  };
  for (const LoadBlock& block : blocks) {
    blocks_.push_back({number(block.high), number(block.low), block.cycles});
    highest_ = std::max(highest_, blocks_.back().high);
  }
}

}  // namespace bempd::model
