#pragma once

#include <cstddef>
#include <memory>

#include "walk/plan.h"

namespace stridegraph {

/// One room with its walk, while somebody edits the room: the walk follows each edit from the pose that is
/// shown. Holds the plan; the planner's library is shared.
class WalkSession {
 public:
  /// What became of the walk after an edit.
  enum class Following {
    kKept,   ///< It still holds: nothing in its way, nothing better worth a turn.
    kBent,   ///< It goes on differently from the frame shown.
    kStuck,  ///< It cannot follow: trouble() says why, and the walk stays as it was.
  };

  explicit WalkSession(std::shared_ptr<const WalkPlanner> planner) : planner_(std::move(planner)) {}

  /// Plans from the scene's starts, whatever was before. Errors as WalkPlanner::plan, and then nothing
  /// changes.
  Result<void> plan(const Scene& scene, const PlanOptions& options = {});

  /// The scene was edited while the walk shows a frame. Where there is no walk under way, plans from the
  /// starts: kBent, or kStuck when none arrives. Starts are not looked at otherwise.
  Result<Following> follow(const Scene& scene, std::size_t frame, const PlanOptions& options = {});

  const Plan& current() const { return plan_; }
  const Scene& scene() const { return scene_; }
  /// Why the last edit could not be followed; the report of the plan that failed.
  const PlanReport& trouble() const { return trouble_; }

 private:
  bool stillHolds(const Scene& scene, std::size_t frame) const;
  bool nothingFreed(const Scene& scene) const;

  std::shared_ptr<const WalkPlanner> planner_;
  Scene scene_;
  Plan plan_;
  PlanReport trouble_;
};

}  // namespace stridegraph
