#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "walk/foot_cleanup.h"
#include "walk/overlaps.h"
#include "walk/pace_tables.h"
#include "walk/plan.h"
#include "walk/search_tables.h"
#include "walk/source_figures.h"
#include "walk/standing_body.h"
#include "walk/traffic.h"

namespace stridegraph {

/// What is known of a library before any plan, and of paces after some.
struct Prepared {
  const MotionLibrary& library;
  const SearchTables& tables;
  const FootCleanup& feet;
  const SourceFigures& sources;
  PaceTables& paces;
  const std::optional<StandingBody>& standing;  ///< What small steps are taken from, where it can stand.
};

/// One walker's part of a scene.
struct PlanTask {
  const FloorPlan& floor;
  Placement start;
  Placement goal;
  Traffic& traffic;
  const Plan* underWay =
      nullptr;  ///< A walk that is to go on differently from `frame` on; null for a new one.
  std::size_t frame = 0;
  std::optional<Refusal> refusal = {};  ///< Why this walker is not even planned.
};

/// One walk in the making: path, motion, synthesis, and the search for better ones. A walk under way stays
/// frame by frame as it is until `frame`, and a little longer: until it comes to the next decision node.
/// All that it is made from has to outlive it; scene and options are in range.
class Planning {
 public:
  /// Finds the first walk, or why there is none.
  Planning(const Prepared& prepared, const Scene& scene, const PlanOptions& options, const PlanTask& task);
  ~Planning();
  Planning(const Planning&) = delete;
  Planning& operator=(const Planning&) = delete;

  /// States looked at so far.
  std::uint64_t expansions() const;
  /// See MotionSearch.
  bool canImprove() const;
  bool improve(std::uint64_t expansions);
  double progress() const;

  /// The best walk so far, made.
  Plan plan() const;
  /// Brings up to date what the report of that plan says of the search.
  void update(PlanReport& report) const;

 private:
  class Stages;
  std::unique_ptr<Stages> stages_;
};

}  // namespace stridegraph
