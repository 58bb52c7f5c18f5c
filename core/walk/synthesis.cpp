#include "walk/synthesis.h"

#include "base/check.h"
#include "walk/edge_motion.h"

namespace stridegraph {
namespace {

/// Appends a frame of `poses`, brought into the room.
void appendPlaced(const Clip& poses, std::size_t frame, const FloorTransform& roomFromEdge, Clip& walk) {
  walk.append(poses.pose(frame));
  const std::size_t last = walk.frameCount() - 1;
  walk.rootPositions[last] = roomFromEdge.apply(poses.rootPositions[frame]);
  Quat& root = walk.rotationsOf(last)[0];
  root = (roomFromEdge.heading.rotation() * root).normalized();
}

/// Contacts at a position on an edge: of the captured frame there, and in a blend of the clip that weighs
/// more.
ContactMask contactsAt(const MotionLibrary& library, const MotionEdge& edge, std::uint32_t position) {
  const std::uint32_t from = library.graph.nodes[edge.from.value].value;
  const std::uint32_t to = library.graph.nodes[edge.to.value].value;
  if (edge.kind == EdgeKind::kClipPiece) return library.contacts[from + position];
  const std::uint32_t left = edge.frames - position;
  return 2 * position < edge.frames ? library.contacts[from + position * edge.sourceSpan / edge.frames]
                                    : library.contacts[to - left * edge.targetSpan / edge.frames];
}

}  // namespace

SynthesisedWalk synthesise(const MotionLibrary& library, const MotionPath& path) {
  STRIDEGRAPH_CHECK(!path.steps.empty());
  SynthesisedWalk walk;
  walk.clip.framesPerSecond = library.frames.framesPerSecond;
  walk.clip.jointCount = library.skeleton.size();
  FloorTransform placement = path.start;
  for (const WalkStep& step : path.steps) {
    const MotionEdge& edge = library.graph.edges[step.edge.value];
    const std::vector<FloorTransform> track = edgeTrack(library, edge);
    const Clip poses = edgePoses(library, edge);
    const FloorTransform atEdgeStart = placement * track[step.begin].inverse();
    const FloorTransform roomFromEdge = placeEdge(library, edge, atEdgeStart);
    // The frame at `begin` was shown by the step before, except at the very beginning.
    const std::uint32_t first = walk.clip.frameCount() == 0 ? step.begin : step.begin + 1;
    for (std::uint32_t p = first; p <= step.end; ++p) {
      appendPlaced(poses, p, roomFromEdge, walk.clip);
      const bool blended = edge.kind == EdgeKind::kTransition && p > 0 && p < edge.frames;
      walk.frameKinds.push_back(blended ? EdgeKind::kTransition : EdgeKind::kClipPiece);
      walk.contacts.push_back(contactsAt(library, edge, p));
    }
    placement = atEdgeStart * track[step.end];
  }
  return walk;
}

}  // namespace stridegraph
