#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/library.h"
#include "math/floor_transform.h"
#include "walk/motion_path.h"

namespace stridegraph {

/// A run of library edges from one decision to the next, with its way over the floor.
struct SearchEdge {
  std::uint32_t to = 0;           ///< Decision node reached.
  std::uint32_t firstSample = 0;  ///< Into SearchGraph::samples: one for each frame shown.
  std::uint32_t sampleCount = 0;
  std::uint32_t firstStep = 0;  ///< Into SearchGraph::steps: the library edges it runs along.
  std::uint32_t stepCount = 0;
  FloorTransform end;             ///< Placement at the end, relative to the placement at its beginning.
  double lengthMetres = 0.0;      ///< Of the root's way over the floor.
  std::uint32_t transitions = 0;  ///< Blends on it.
  double transitionDistanceMetres = 0.0;  ///< Sum of their distances.
};

/// A library prepared for searching: nodes with only one way on are passed over, and every way knows its
/// track. Built once for a library; immutable.
class SearchGraph {
 public:
  explicit SearchGraph(const MotionLibrary& library);

  std::size_t nodeCount() const { return firstEdge_.size() - 1; }
  /// Ways on from a decision node.
  std::span<const SearchEdge> edgesFrom(std::size_t node) const;
  /// Ways to begin: from a captured frame of the graph (every second one) to the next decision node.
  std::span<const SearchEdge> starts() const { return starts_; }
  /// Floor points of the root for each frame shown, relative to the placement at the edge's beginning.
  std::span<const Eigen::Vector2f> samplesOf(const SearchEdge& edge) const;
  /// The library edges along a way.
  std::span<const WalkStep> stepsOf(const SearchEdge& edge) const;
  /// The placement at the end of a library edge, relative to the one at its beginning.
  const FloorTransform& endOf(EdgeIndex edge) const { return ends_[edge.value]; }

 private:
  struct Builder;
  std::vector<SearchEdge> edges_;
  std::vector<std::uint32_t> firstEdge_;
  std::vector<SearchEdge> starts_;
  std::vector<Eigen::Vector2f> samples_;
  std::vector<WalkStep> steps_;
  std::vector<FloorTransform> ends_;
};

}  // namespace stridegraph
