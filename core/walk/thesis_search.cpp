#include "walk/thesis_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "math/random.h"
#include "walk/piece_motion.h"
#include "walk/search_heap.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kNoParent = 0xffffffffU;
constexpr std::uint64_t kExpansionsBetweenTimeChecks = 256;

/// A vertex of the graph reached on the floor, and how.
struct State {
  std::uint32_t node = 0;
  FloorTransform placement;
  std::uint32_t parent = kNoParent;
  EdgeIndex via;
};

/// Eq. 5.11; larger is worse.
double fitness(const FloorTransform& placement, const Vec2& target) {
  const Vec2 towards = target - placement.translation;
  const double distance = towards.norm();
  // (2 - cos alpha) d, with d cos alpha as the dot product.
  return 2.0 * distance - placement.heading.direction().dot(towards);
}

class Traversal {
 public:
  Traversal(const MotionQuery& query, const ThesisSearchParams& params) : query_(query), params_(params) {}

  MotionResult run() {
    Random random(query_.seed);
    const MotionGraph& graph = query_.library.graph;
    const Vec2 ahead = query_.path[1] - query_.path[0];
    const Heading heading =
        query_.start.heading ? Heading::fromAngle(*query_.start.heading) : Heading::alongDirection(ahead);
    states_.push_back({static_cast<std::uint32_t>(random.below(graph.nodes.size())),
                       {query_.start.position, heading},
                       kNoParent,
                       {}});
    std::uint32_t at = 0;
    for (std::size_t s = 0; s < query_.subgoals.size(); ++s) {
      const bool last = s + 1 == query_.subgoals.size();
      const double reach =
          last ? query_.goalRadiusMetres : std::max(params_.reachMetres, query_.goalRadiusMetres);
      at = traverse(at, query_.subgoals[s], reach);
      if (at == kNoParent) {
        result_.explanation = fmt::format("the walk does not get within {:.2f} m of subgoal {} of {}", reach,
                                          s + 1, query_.subgoals.size());
        return std::move(result_);
      }
    }
    result_.status = SearchStatus::kArrived;
    result_.path = pathTo(at);
    return std::move(result_);
  }

 private:
  /// Algorithm 5.5.2. The state within reach of the target, or kNoParent with result_.status set.
  std::uint32_t traverse(std::uint32_t from, const Vec2& target, double reachMetres) {
    const MotionGraph& graph = query_.library.graph;
    SearchHeap queue;
    queue.push(fitness(states_[from].placement, target), from);
    while (!queue.empty()) {
      if (budgetSpent()) {
        result_.status = SearchStatus::kBudgetSpent;
        return kNoParent;
      }
      const std::uint32_t id = queue.pop();
      ++result_.expansions;
      const State state = states_[id];
      for (std::uint32_t e = graph.firstEdge[state.node]; e < graph.firstEdge[state.node + 1]; ++e) {
        const EdgeIndex edge(e);
        if (params_.checkCollisions && !isFree(state.placement, edge)) continue;
        const auto next = static_cast<std::uint32_t>(states_.size());
        states_.push_back(
            {graph.edges[e].to.value, state.placement * query_.tables.graph.endOf(edge), id, edge});
        const FloorTransform& placement = states_.back().placement;
        if ((placement.translation - target).norm() < reachMetres) return next;
        queue.push(fitness(placement, target), next);
      }
    }
    result_.status = SearchStatus::kNoMotion;
    return kNoParent;
  }

  /// Tracks are made when an edge is first looked at: most of a library never is.
  bool isFree(const FloorTransform& from, EdgeIndex edge) {
    tracks_.resize(query_.library.graph.edges.size());
    std::vector<FloorTransform>& track = tracks_[edge.value];
    if (track.empty()) {
      const MotionGraph& graph = query_.library.graph;
      track = pieceTrack(query_.library, pieceOf(graph, graph.edges[edge.value]));
    }
    return std::all_of(track.begin(), track.end(), [&](const FloorTransform& placement) {
      return query_.plan.isFree(from * placement.translation);
    });
  }

  bool budgetSpent() const {
    if (result_.expansions >= params_.maxExpansions) return true;
    return query_.outOfTime && result_.expansions % kExpansionsBetweenTimeChecks == 0 && query_.outOfTime();
  }

  MotionPath pathTo(std::uint32_t id) const {
    const MotionGraph& graph = query_.library.graph;
    MotionPath path;
    for (; states_[id].parent != kNoParent; id = states_[id].parent) {
      const MotionPiece piece = pieceOf(graph, graph.edges[states_[id].via.value]);
      path.steps.push_back({piece, 0, piece.frames});
    }
    path.start = states_[id].placement;
    std::reverse(path.steps.begin(), path.steps.end());
    if (path.steps.empty()) {
      // The start lies within reach of the goal: the walk is the first pose alone.
      path.steps.push_back({pieceOf(graph, graph.edges[graph.firstEdge[states_[id].node]]), 0, 0});
    }
    return path;
  }

  const MotionQuery& query_;
  const ThesisSearchParams& params_;
  std::vector<State> states_;
  std::vector<std::vector<FloorTransform>> tracks_;  ///< Of edges, relative to where they begin.
  MotionResult result_;
};

}  // namespace

MotionResult thesisSearch(const MotionQuery& query, const ThesisSearchParams& params) {
  return Traversal(query, params).run();
}

}  // namespace stridegraph
