#include "walk/edge_motion.h"

#include "motion/transition_blend.h"

namespace stridegraph {
namespace {

TransitionBlend blendOf(const MotionLibrary& library, const MotionEdge& edge) {
  const std::size_t from = library.graph.nodes[edge.from.value].value;
  const std::size_t to = library.graph.nodes[edge.to.value].value;
  return {{&library.frames, from, from + edge.sourceSpan},
          {&library.frames, to - edge.targetSpan, to},
          std::size_t{edge.frames} + 1};
}

/// Placements at positions 0..frames in the world of edgePoses().
std::vector<FloorTransform> placementsOn(const MotionLibrary& library, const MotionEdge& edge) {
  std::vector<FloorTransform> placements;
  if (edge.kind == EdgeKind::kTransition) {
    placements = blendTrack(blendOf(library, edge));
    for (FloorTransform& placement : placements) placement.heading = placement.heading - library.facingOffset;
    return placements;
  }
  const std::size_t from = library.graph.nodes[edge.from.value].value;
  for (std::size_t p = 0; p <= edge.frames; ++p)
    placements.push_back(library.placementAt(FrameIndex(from + p)));
  return placements;
}

}  // namespace

std::vector<FloorTransform> edgeTrack(const MotionLibrary& library, const MotionEdge& edge) {
  std::vector<FloorTransform> track = placementsOn(library, edge);
  const FloorTransform fromWorld = track.front().inverse();
  track.front() = {};
  for (std::size_t p = 1; p < track.size(); ++p) track[p] = fromWorld * track[p];
  return track;
}

Clip edgePoses(const MotionLibrary& library, const MotionEdge& edge) {
  if (edge.kind == EdgeKind::kTransition) return blendPoses(blendOf(library, edge));
  Clip poses;
  poses.framesPerSecond = library.frames.framesPerSecond;
  poses.jointCount = library.frames.jointCount;
  const std::size_t from = library.graph.nodes[edge.from.value].value;
  for (std::size_t p = 0; p <= edge.frames; ++p) poses.append(library.frames.pose(from + p));
  return poses;
}

FloorTransform placeEdge(const MotionLibrary& library, const MotionEdge& edge,
                         const FloorTransform& placement) {
  return placement * library.placementAt(library.graph.nodes[edge.from.value]).inverse();
}

}  // namespace stridegraph
