#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "graph/library.h"
#include "math/rotation.h"

namespace stridegraph::testing {

inline constexpr std::uint32_t kClipFrames = 41;
inline constexpr double kStepMetres = 0.05;

/// A clip of a body that goes forward a length for each frame and turns evenly.
template <typename StepLength>
void appendClip(MotionLibrary& library, const std::string& name, Angle turnPerFrame, StepLength metresAfter) {
  const auto first = static_cast<std::uint32_t>(library.frames.frameCount());
  FloorTransform placement;
  for (std::uint32_t f = 0; f < kClipFrames; ++f) {
    const FloorTransform step{{0.0, metresAfter(f)}, Heading::fromAngle(turnPerFrame)};
    const std::vector<Quat> rotations = {placement.heading.rotation(),
                                         axisRotation(Axis::kX, Angle::degrees(f % 2 == 0 ? 5 : -5))};
    const Vec3 root(placement.translation.x(), 1.0, placement.translation.y());
    library.frames.append({root, rotations});
    library.contacts.push_back(static_cast<ContactMask>(f % 4 < 2 ? 1 : 0));
    placement = placement * step;
  }
  library.clips.push_back({name, first, kClipFrames, false});
}

/// 5 cm a frame.
inline void appendArc(MotionLibrary& library, const std::string& name, Angle turnPerFrame) {
  appendClip(library, name, turnPerFrame, [](std::uint32_t) { return kStepMetres; });
}

/// A library that can be checked by hand: a hip with one foot, three clips (straight on, and an eighth of a
/// circle, or another arc, to either side between its nodes). In each clip, transitions of 13 frames arrive
/// at frame 14 and leave at frame 26, from every clip to every clip: 6 nodes, 3 clip pieces, 9 transitions.
inline MotionLibrary threeArcs(Angle arc = Angle::degrees(45.0)) {
  MotionLibrary library;
  library.skeleton.joints = {{"hip", {}, {0, 0, 0}}, {"foot", JointIndex(std::size_t{0}), {0, -1, 0}}};
  const std::vector<BvhChannel> rotations = {BvhChannel::kZRotation, BvhChannel::kXRotation,
                                             BvhChannel::kYRotation};
  std::vector<BvhChannel> root = {BvhChannel::kXPosition, BvhChannel::kYPosition, BvhChannel::kZPosition};
  root.insert(root.end(), rotations.begin(), rotations.end());
  library.layout.channels = {root, rotations};
  library.layout.endSiteNames = {"", ""};
  library.frames.jointCount = 2;
  library.contactJoints = {JointIndex(std::size_t{1})};
  appendArc(library, "straight", Angle());
  appendArc(library, "left", arc * (1.0 / 12.0));
  appendArc(library, "right", arc * (-1.0 / 12.0));
  MotionGraph& graph = library.graph;
  for (std::uint32_t clip = 0; clip < 3; ++clip) {
    graph.nodes.emplace_back(std::size_t{clip * kClipFrames + 14});
    graph.nodes.emplace_back(std::size_t{clip * kClipFrames + 26});
  }
  for (std::size_t clip = 0; clip < 3; ++clip) {
    graph.firstEdge.push_back(static_cast<std::uint32_t>(graph.edges.size()));
    graph.edges.push_back(
        {NodeIndex(2 * clip), NodeIndex(2 * clip + 1), EdgeKind::kClipPiece, 12, 0, 0, 0.0F});
    graph.firstEdge.push_back(static_cast<std::uint32_t>(graph.edges.size()));
    for (std::size_t target = 0; target < 3; ++target) {
      graph.edges.push_back(
          {NodeIndex(2 * clip + 1), NodeIndex(2 * target), EdgeKind::kTransition, 12, 12, 12, 0.02F});
    }
  }
  graph.firstEdge.push_back(static_cast<std::uint32_t>(graph.edges.size()));
  return library;
}

/// threeArcs() and a clip of going straight and then standing from frame 27 on: a transition from the
/// straight clip leads to its frame 14, none leads on, as at the end of a captured clip.
inline MotionLibrary threeArcsAndAStop() {
  MotionLibrary library = threeArcs();
  appendClip(library, "stop", Angle(), [](std::uint32_t f) { return f < 27 ? kStepMetres : 0.0; });
  MotionGraph& graph = library.graph;
  graph.nodes.emplace_back(std::size_t{3 * kClipFrames + 14});
  // Behind the other three ways on from the straight clip's end.
  graph.edges.insert(graph.edges.begin() + 4, {NodeIndex(std::size_t{1}), NodeIndex(std::size_t{6}),
                                               EdgeKind::kTransition, 12, 12, 12, 0.02F});
  for (std::size_t n = 2; n < graph.firstEdge.size(); ++n) ++graph.firstEdge[n];
  graph.firstEdge.push_back(graph.firstEdge.back());
  return library;
}

/// threeArcs() whose straight clip stands until frame 10.
inline MotionLibrary threeArcsAndAStart() {
  MotionLibrary library = threeArcs();
  for (std::uint32_t f = 0; f < 10; ++f)
    library.frames.rootPositions[f].z() = library.frames.rootPositions[10].z();
  return library;
}

}  // namespace stridegraph::testing
