#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "graph/library.h"
#include "math/floor_transform.h"
#include "walk/motion_path.h"
#include "walk/strain.h"

namespace stridegraph {

/// A run of pieces of the library from one decision to the next, with its way over the floor.
struct SearchEdge {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t from = kNone;  ///< Decision node where it begins; kNone of a way to begin a walk.
  std::uint32_t to = 0;  ///< Decision node reached; kNone where the clip ends: a walk may only end there.
  std::uint32_t firstSample = 0;  ///< Into SearchGraph::samples: one for each frame shown.
  std::uint32_t sampleCount = 0;
  std::uint32_t firstStep = 0;  ///< Into SearchGraph::steps: the pieces it runs along.
  std::uint32_t stepCount = 0;
  std::uint32_t settledSample = kNone;  ///< First sample at which the body has come to a stand.
  std::uint32_t transitions = 0;        ///< Blends on it.
  FloorTransform settledEnd;            ///< Placement there, relative to the one at the edge's beginning.
  FloorTransform end;                   ///< Placement at the end, relative to the placement at its beginning.
  double lengthMetres = 0.0;            ///< Of the root's way over the floor.
  double strain = 0.0;                  ///< Sum of its frames' (frameStrains).
  double bendRadians = 0.0;             ///< Turn that bending adds to it, to whichever side.
  double transitionDistanceMetres = 0.0;  ///< Sum of their distances.

  /// The share of it that is gone when the body has come to a stand; only where it does.
  double settledShare() const {
    return static_cast<double>(settledSample + 1) / static_cast<double>(sampleCount);
  }
};

/// A way to begin a walk.
struct SearchStart {
  SearchEdge edge;
  bool stands = false;  ///< Its first frame shows a standing body.
};

/// A library prepared for searching: nodes with only one way on are passed over, and every way knows its
/// track. Each way, and each way to begin, is there as captured and bent to either side, so that a walk can
/// keep to a direction or a curve that no clip shows. A walk may also begin with frames before the first node
/// of their clip and end with frames behind the last one, where the body comes to a stand. Built once for a
/// library; immutable.
class SearchGraph {
 public:
  /// By how much ways are bent: a curve of 1 m, as people walk round a corner. The body turns by some 30
  /// degrees over a planted foot, half of it before and half after it faces as the foot does. Over all test
  /// maps feet slide as much as with half the bends, walks are shorter and no joint is driven harder; with
  /// more of it walks hardly get shorter.
  static constexpr Angle kBendPerMetre = Angle::degrees(60.0);
  /// Faster gaits are bent less: metres per second squared, towards the curve's middle.
  static constexpr double kBendAcceleration = 1.5;

  explicit SearchGraph(const MotionLibrary& library) : SearchGraph(library, capturedLimits(library)) {}
  /// With the limits that frames' strains are measured by.
  SearchGraph(const MotionLibrary& library, const MotionLimits& limits);

  std::size_t nodeCount() const { return firstEdge_.size() - 1; }
  /// All ways between decision nodes, and their place in this list.
  std::span<const SearchEdge> edges() const { return edges_; }
  std::uint32_t indexOf(const SearchEdge& edge) const {
    return static_cast<std::uint32_t>(&edge - edges_.data());
  }
  /// The decision node at a frame of the library; SearchEdge::kNone where there is none.
  std::uint32_t decisionAt(FrameIndex frame) const { return decisionAt_[frame.value]; }
  /// Ways on from a decision node.
  std::span<const SearchEdge> edgesFrom(std::size_t node) const;
  /// Those of them that do not bend transitions, where any others are bent: half as many, and walks along
  /// them are hardly longer.
  std::span<const SearchEdge> usualEdgesFrom(std::size_t node) const;
  /// Ways that lead to a decision node: their places in edges(), ascending.
  std::span<const std::uint32_t> edgesInto(std::size_t node) const;
  /// Ways to begin: from a captured frame to the next decision node. Not from each: neighbours begin walks
  /// that hardly differ.
  std::span<const SearchStart> starts() const { return starts_; }
  /// Half of those in motion, and all from a stand: what rooms that are not tight can do with.
  std::span<const SearchStart> usualStarts() const { return std::span(starts_).first(usualStartCount_); }
  /// Floor points of the root for each frame shown, relative to the placement at the edge's beginning.
  std::span<const Eigen::Vector2f> samplesOf(const SearchEdge& edge) const;
  /// Where the body faces at each of these, as (sin, cos) relative to the beginning.
  std::span<const Eigen::Vector2f> headingsOf(const SearchEdge& edge) const;
  /// The pieces along a way.
  std::span<const WalkStep> stepsOf(const SearchEdge& edge) const;
  /// The placement at the end of a library edge, relative to the one at its beginning.
  const FloorTransform& endOf(EdgeIndex edge) const { return ends_[edge.value]; }
  /// The greatest mean speed of any way.
  double fastestMetresPerFrame() const { return fastestMetresPerFrame_; }
  /// Whether a walk can begin, or end, with a standing body.
  bool canStartStanding() const { return canStartStanding_; }
  bool canEndStanding() const { return canEndStanding_; }

 private:
  friend class SearchGraphBuilder;
  std::vector<SearchEdge> edges_;
  std::vector<std::uint32_t> firstEdge_;
  std::vector<std::uint32_t> usualEnd_;  ///< For each node, behind its last usual edge.
  std::vector<std::uint32_t> edgesInto_;
  std::vector<std::uint32_t> firstInto_;   ///< For each node, into edgesInto_; and the end.
  std::vector<std::uint32_t> decisionAt_;  ///< For each frame of the library.
  std::vector<SearchStart> starts_;        ///< The usual ones first.
  std::size_t usualStartCount_ = 0;
  std::vector<Eigen::Vector2f> samples_;
  std::vector<Eigen::Vector2f> headings_;
  std::vector<WalkStep> steps_;
  std::vector<FloorTransform> ends_;
  double fastestMetresPerFrame_ = 0.0;
  bool canStartStanding_ = false;
  bool canEndStanding_ = false;
};

}  // namespace stridegraph
