#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "base/result.h"
#include "graph/library.h"
#include "walk/anytime_plan.h"
#include "walk/foot_cleanup.h"
#include "walk/pace_tables.h"
#include "walk/plan.h"
#include "walk/search_tables.h"
#include "walk/source_figures.h"
#include "walk/standing_body.h"

namespace stridegraph {

struct Prepared;

/// A library made ready for planning walk after walk: the session facade. Planning the same scene with the
/// same options gives the same walk. What paces asked for cost is kept once known (PaceTables), so one thread
/// plans at a time.
class WalkPlanner {
 public:
  explicit WalkPlanner(std::shared_ptr<const MotionLibrary> library);

  const MotionLibrary& library() const { return *library_; }

  /// Plans a walk through a scene: path, motion, synthesis. A scene or option out of range is an error; that
  /// there is no way is a plan whose status says so.
  /// Walkers are planned one after the other, each around those before it (prioritised planning, Erdmann and
  /// Lozano-Perez 1987); where one finds no way, it goes first and the others are planned again.
  Result<Plan> plan(const Scene& scene, const PlanOptions& options = {}) const;
  /// The same with the first walks at once and better ones later, as many as the options' improvement
  /// expansions allow. The planner has to outlive it.
  Result<AnytimePlan> begin(const Scene& scene, const PlanOptions& options = {}) const;

  /// Plans anew for a walk under way that shows this frame, and for its others: it stays as it is until then
  /// and goes on in the scene as it is now, from the present pose (kept exactly: its steps, its way and its
  /// frames). A walk that still holds is kept where no obstacle has gone, without another search, and also
  /// where another would save less than 3 % of what is left to go. `current` has arrived, in a scene with as
  /// many walkers; where a walker cannot turn off any more, its report says so.
  Result<Plan> replan(const Plan& current, std::size_t frame, const Scene& scene,
                      const PlanOptions& options = {}) const;
  /// The same with better ones later.
  Result<AnytimePlan> beginOnward(const Plan& current, std::size_t frame, const Scene& scene,
                                  const PlanOptions& options = {}) const;

 private:
  Prepared prepared() const;

  std::shared_ptr<const MotionLibrary> library_;
  SourceFigures sources_;
  SearchTables tables_;
  std::unique_ptr<PaceTables> paces_;
  FootCleanup feet_;
  std::optional<StandingBody> standing_;
};

}  // namespace stridegraph
