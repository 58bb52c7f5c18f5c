#include "walk/pace_tables.h"

#include <algorithm>

#include "walk/constraint_cost.h"
#include "walk/walk_cost.h"

namespace stridegraph {

std::shared_ptr<const SteeringTable> PaceTables::steering(const WalkConstraints& wishes) {
  WalkConstraints pace;
  pace.gait = wishes.gait;
  pace.minSpeedMetresPerSecond = wishes.minSpeedMetresPerSecond;
  pace.maxSpeedMetresPerSecond = wishes.maxSpeedMetresPerSecond;
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.wishes == pace; });
  if (known != kept_.end()) return known->table;
  const ConstraintCost cost(pace, framesPerSecond_);
  if (kept_.size() == kMost) kept_.erase(kept_.begin());
  kept_.push_back(
      {pace, std::make_shared<const SteeringTable>(graph_, WalkCost{}, framesPerSecond_,
                                                   [&](const SearchEdge& way) { return cost.ofPace(way); })});
  return kept_.back().table;
}

}  // namespace stridegraph
