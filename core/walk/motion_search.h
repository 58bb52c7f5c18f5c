#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "path/distance_field.h"
#include "path/floor_plan.h"
#include "scene/scene.h"
#include "walk/motion_path.h"
#include "walk/pace_tables.h"
#include "walk/search_tables.h"
#include "walk/traffic.h"

namespace stridegraph {

/// Which search finds the motion: `guided` is ours, `thesis` the best-first search of section 5.5 as printed,
/// `thesis-checked` the same but for edges that collide, which it leaves out.
enum class SearchKind { kGuided, kThesis, kThesisChecked };

inline constexpr std::array kAllSearchKinds = {SearchKind::kGuided, SearchKind::kThesis,
                                               SearchKind::kThesisChecked};

std::string_view searchName(SearchKind search);  ///< "guided", "thesis", "thesis-checked"
std::optional<SearchKind> searchFromName(std::string_view name);

/// Where a walk that is under way goes on: at a decision node, at a placement, at a time.
struct Onward {
  std::uint32_t node = 0;
  FloorTransform placement;
  std::uint32_t frame = 0;  ///< Of the walk.
};

/// What a motion search is asked. Start and goal are free and a path leads from one to the other.
struct MotionQuery {
  const MotionLibrary& library;
  const SearchTables& tables;
  const FloorPlan& plan;
  Placement start;  ///< Without a heading the search may choose one.
  Placement goal;
  double goalRadiusMetres = 0.1;  ///< The walk ends with the root this near the goal,
  Angle goalTurn{};               ///< and turned at most so far from its heading, if it has one.
  std::span<const Vec2> path{};   ///< From start to goal, at least two points.
  std::span<const Vec2>
      subgoals{};        ///< Along the path; the last one is the goal. Only the thesis search needs them.
  bool standing = true;  ///< The walk begins and ends with a standing body where the library can.
  std::uint64_t seed = 1;
  /// Whether a walk found will do, from its last metres and the frame of the walk at which these begin; where
  /// it will not, the guided search looks at some more before it takes the first. May be empty.
  std::function<bool(const MotionPath&, std::uint32_t)> accepts{};
  /// Another walk there costs so much, metres: the guided search looks briefly for one that costs less.
  double costBound = std::numeric_limits<double>::infinity();
  /// States looked at beyond those of the first walk to find cheaper ones; 0 takes the first.
  std::uint64_t improvementExpansions = 0;
  /// A walk that is at most so many times as long as the field says the disc's way is is good enough.
  std::optional<double> enoughRatio{};
  std::function<bool()> outOfTime{};  ///< Asked now and then; true ends the search. May be empty.
  /// How far it is to the goal from anywhere, finite at the start; null where a search has to find out
  /// itself.
  const DistanceField* field = nullptr;
  /// What moves while the walk goes on; null when nothing does. The thesis search does not look at it.
  Traffic* traffic = nullptr;
  /// What the scene asks for beyond getting there; null when nothing. The thesis search does not look at it.
  const WalkConstraints* constraints = nullptr;
  /// What is kept of the paces that scenes ask for, from one walk to the next; null where a search has to
  /// find out itself.
  PaceTables* paces = nullptr;
  /// A walk under way: `start` is where it goes on, and all else holds for what is left of it.
  std::optional<Onward> onward{};
};

enum class SearchStatus { kArrived, kNoMotion, kBudgetSpent };

struct MotionResult {
  SearchStatus status = SearchStatus::kNoMotion;
  MotionPath path;               ///< Without steps unless arrived.
  double costMetres = 0.0;       ///< Of the path, by WalkCost,
  double blendMetres = 0.0;      ///< and for how much of it its transitions count.
  std::uint64_t expansions = 0;  ///< States whose ways on were looked at.
  std::string explanation;       ///< When not arrived: what stood in the way.
  /// From start to goal, where the scene's areas lead the search another way than the query's path; else
  /// empty.
  std::vector<Vec2> way;

  /// What going the path costs, whatever price its transitions have.
  double goingMetres() const { return costMetres - blendMetres; }
};

/// A search that has given its first answer. Some can be carried on for better walks, slice by slice.
class MotionSearch {
 public:
  virtual ~MotionSearch() = default;

  /// The best walk so far, or why there is none.
  virtual const MotionResult& best() const = 0;
  /// Whether a better walk may still be found: there is one, the query's improvement expansions are not used
  /// up, nor its time, and the walk is not good enough.
  virtual bool canImprove() const { return false; }
  /// Looks at up to so many more states. Whether best() is another one now. In what slices it is called makes
  /// no difference.
  virtual bool improve([[maybe_unused]] std::uint64_t expansions) { return false; }
  /// The share of the improvement expansions that is used up, 0..1; 1 when nothing is left to be done.
  virtual double progress() const { return 1.0; }
};

/// Looks for a walk with the search of that kind. What the query refers to has to outlive the search.
std::unique_ptr<MotionSearch> searchMotion(SearchKind kind, const MotionQuery& query);

}  // namespace stridegraph
