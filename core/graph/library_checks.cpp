#include "graph/library_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "base/utf8.h"
#include "graph/graph_building.h"
#include "graph/library_limits.h"
#include "motion/bvh_still_part.h"

namespace stridegraph {
namespace {

using Fault = std::optional<std::string>;

/// With fewer even a single stretch of a clip that repeats itself might not fit in.
constexpr std::uint32_t kLeastMostTransitions = 1000;

/// Lengths beyond this are no body's and no room's: their squares and sums would no longer tell frames apart.
constexpr double kFarthestMetres = 1e6;

/// What is wrong with a length along each axis; empty when nothing is.
std::string faultInPlace(const Vec3& place) {
  if (!place.allFinite()) return "is not finite";
  if (place.cwiseAbs().maxCoeff() > kFarthestMetres) return fmt::format("is more than {} m", kFarthestMetres);
  return {};
}

bool isBetween(double value, double low, double high) {
  return value >= low && value <= high;
}

Fault faultInClips(const MotionLibrary& library) {
  std::size_t next = 0;
  for (const LibraryClip& clip : library.clips) {
    if (clip.frameCount == 0) return fmt::format("clip {} has no frames", clip.name);
    if (clip.firstFrame != next)
      return fmt::format("clip {} begins at frame {}, frame {} expected", clip.name, clip.firstFrame, next);
    next += clip.frameCount;
  }
  if (next != library.frames.frameCount())
    return fmt::format("clips of {} frames for a library of {}", next, library.frames.frameCount());
  return {};
}

Fault faultInContacts(const MotionLibrary& library) {
  const std::size_t count = library.contactJoints.size();
  if (count > 8) return fmt::format("{} contact joints, at most 8 expected", count);
  for (std::size_t k = 0; k < count; ++k) {
    if (library.contactJoints[k].value >= library.skeleton.size())
      return fmt::format("contact joint {} of {}", library.contactJoints[k].value, library.skeleton.size());
    if (k > 0 && library.contactJoints[k] <= library.contactJoints[k - 1])
      return std::string("contact joints out of order");
  }
  if (library.contacts.size() != library.frames.frameCount())
    return fmt::format("contacts of {} frames for a library of {}", library.contacts.size(),
                       library.frames.frameCount());
  for (const ContactMask mask : library.contacts) {
    if ((static_cast<unsigned>(mask) >> count) != 0U)
      return fmt::format("contact mask {} for {} contact joints", mask, count);
  }
  return {};
}

Fault faultInEdge(const MotionLibrary& library, const MotionEdge& edge) {
  const std::size_t nodeCount = library.graph.nodes.size();
  if (edge.from.value >= nodeCount || edge.to.value >= nodeCount)
    return fmt::format("an edge from node {} to node {} of {}", edge.from.value, edge.to.value, nodeCount);
  const FrameIndex from = library.graph.nodes[edge.from.value];
  const FrameIndex to = library.graph.nodes[edge.to.value];
  const LibraryClip& source = library.clipOf(from);
  const LibraryClip& target = library.clipOf(to);
  const std::string name = fmt::format("the edge from frame {} to frame {}", from.value, to.value);
  if (edge.kind == EdgeKind::kClipPiece) {
    if (to <= from || &source != &target) return name + " is a clip piece across clips or back in time";
    if (edge.frames != to.value - from.value) return fmt::format("{} shows {} frames", name, edge.frames);
    return {};
  }
  if (edge.kind != EdgeKind::kTransition) return name + " is of no known kind";
  if (edge.frames < 1 || edge.frames > 1000 || edge.sourceSpan < 1 || edge.targetSpan < 1)
    return fmt::format("{} blends {} frames over {} and {}", name, edge.frames, edge.sourceSpan,
                       edge.targetSpan);
  const std::uint32_t sourceLeft = source.firstFrame + source.frameCount - 1 - from.value;
  if (edge.sourceSpan > sourceLeft || edge.targetSpan > to.value - target.firstFrame)
    return name + " blends beyond the end of a clip";
  if (!(edge.distanceMetres >= 0.0F) || !std::isfinite(edge.distanceMetres))
    return name + " has no sound distance";
  return {};
}

Fault faultInGraph(const MotionLibrary& library) {
  const MotionGraph& graph = library.graph;
  if (graph.nodes.empty() || graph.edges.empty()) return std::string("an empty graph");
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (graph.nodes[n].value >= library.frames.frameCount() ||
        (n > 0 && graph.nodes[n] <= graph.nodes[n - 1]))
      return fmt::format("node {} out of range or order", n);
  }
  const auto key = [](const MotionEdge& edge) { return std::tuple(edge.from, edge.to, edge.kind); };
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (Fault fault = faultInEdge(library, graph.edges[e])) return fault;
    if (e > 0 && key(graph.edges[e]) < key(graph.edges[e - 1])) return fmt::format("edge {} out of order", e);
  }
  MotionGraph indexed = graph;
  indexEdges(indexed);
  if (indexed.firstEdge != graph.firstEdge) return std::string("a wrong index of edges");
  if (largestStronglyConnectedPart(graph).nodes.size() != graph.nodes.size())
    return std::string("a graph with dead ends");
  return {};
}

Fault faultInRegions(const MotionLibrary& library) {
  const auto reachesInOneClip = [&](FrameIndex first, std::uint32_t span) {
    if (first.value >= library.frames.frameCount()) return false;
    const LibraryClip& clip = library.clipOf(first);
    return span >= 1 && span < clip.firstFrame + clip.frameCount - first.value;
  };
  for (std::size_t r = 0; r < library.regions.size(); ++r) {
    const AlikeRegion& region = library.regions[r];
    if (!reachesInOneClip(region.row, region.rowSpan) ||
        !reachesInOneClip(region.column, region.columnSpan) || region.column <= region.row)
      return fmt::format("region {} out of range", r);
    if (!(region.distanceMetres >= 0.0F) || !std::isfinite(region.distanceMetres))
      return fmt::format("region {} has no sound distance", r);
    if (r > 0 && !(library.regions[r - 1] < region)) return fmt::format("region {} out of order", r);
  }
  return {};
}

Fault faultInAmounts(const MotionLibrary& library) {
  struct Amount {
    const char* things;
    std::size_t found;
    std::size_t most;
  };
  const Amount amounts[] = {{"clips", library.clips.size(), kMostLibraryClips},
                            {"frames", library.frames.frameCount(), kMostLibraryFrames},
                            {"rotations", library.frames.rotations.size(), kMostLibraryRotations},
                            {"regions", library.regions.size(), kMostLibraryRegions},
                            {"notes", library.notes.size(), kMostLibraryNotes},
                            {"bytes of licence", library.license.size(), kMostLicenseBytes}};
  for (const Amount& amount : amounts) {
    if (amount.found > amount.most)
      return fmt::format("{} {}, at most {} expected", amount.found, amount.things, amount.most);
  }
  return {};
}

Fault faultInNotes(const MotionLibrary& library) {
  for (std::size_t n = 0; n < library.notes.size(); ++n) {
    for (const std::string* text : {&library.notes[n].message, &library.notes[n].place.file}) {
      if (text->size() > kMostNoteBytes)
        return fmt::format("note {} of {} bytes, at most {} expected", n, text->size(), kMostNoteBytes);
      if (!isUtf8(*text)) return fmt::format("note {} is not UTF-8", n);
    }
  }
  return {};
}

}  // namespace

Fault faultIn(const LibraryParams& params) {
  if (!(params.thresholdMetres > 0.0) || !std::isfinite(params.thresholdMetres))
    return fmt::format("a threshold of {} m, more than 0 expected", params.thresholdMetres);
  if (params.transitionFrames < 2 || params.transitionFrames > 120)
    return fmt::format("transitions of {} frames, 2 to 120 expected", params.transitionFrames);
  if (!isBetween(params.framesPerSecond, 1.0, 240.0))
    return fmt::format("{} frames a second, 1 to 240 expected", params.framesPerSecond);
  if (params.neighbourFrames > 100)
    return fmt::format("a neighbourhood of {} frames, 0 to 100 expected", params.neighbourFrames);
  if (!isBetween(params.largestSpanRatio, 1.0, 2.0))
    return fmt::format("spans {} times as long, 1 to 2 expected", params.largestSpanRatio);
  if (params.mostTransitions < kLeastMostTransitions)
    return fmt::format("{} transitions at most, {} or more expected", params.mostTransitions,
                       kLeastMostTransitions);
  return {};
}

Fault faultIn(const Skeleton& skeleton) {
  if (skeleton.joints.empty()) return std::string("a skeleton without joints");
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    if ((j == 0) != !joint.parent) return fmt::format("joint {} is {}a root", j, j == 0 ? "not " : "");
    if (const std::string fault = faultInPlace(joint.offset); !fault.empty())
      return fmt::format("the offset of joint {} {}", joint.name, fault);
    if (!joint.parent) continue;
    if (joint.parent->value >= j) return fmt::format("joint {} comes before its parent", joint.name);
    if (skeleton.joints[joint.parent->value].isEndSite)
      return fmt::format("joint {} hangs on an end site", joint.name);
  }
  if (skeleton.joints[0].isEndSite) return std::string("a root that is an end site");
  return {};
}

Fault faultIn(const Skeleton& skeleton, const Clip& clip) {
  if (!(clip.framesPerSecond > 0.0) || !std::isfinite(clip.framesPerSecond))
    return fmt::format("{} frames a second, more than 0 expected", clip.framesPerSecond);
  if (clip.jointCount != skeleton.size() || clip.rotations.size() != clip.frameCount() * clip.jointCount)
    return fmt::format("{} rotations in {} frames for {} joints", clip.rotations.size(), clip.frameCount(),
                       skeleton.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    if (const std::string fault = faultInPlace(clip.rootPositions[f]); !fault.empty())
      return fmt::format("the root's position in frame {} {}", f, fault);
    const PoseView pose = clip.pose(f);
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      if (!isBetween(pose.rotations[j].norm(), 0.999, 1.001))
        return fmt::format("the rotation of joint {} in frame {} is not of unit length",
                           skeleton.joints[j].name, f);
    }
  }
  return {};
}

Fault faultIn(const MotionLibrary& library) {
  if (Fault fault = faultIn(library.params)) return fault;
  if (Fault fault = faultInAmounts(library)) return fault;
  if (Fault fault = faultInNotes(library)) return fault;
  if (Fault fault = faultIn(library.skeleton)) return fault;
  if (Fault fault = faultIn(library.skeleton, library.frames)) return fault;
  if (library.frames.framesPerSecond != library.params.framesPerSecond)
    return fmt::format("{} frames a second in a library of {}", library.frames.framesPerSecond,
                       library.params.framesPerSecond);
  if (!(library.layout.unitsPerMetre > 0.0) || !std::isfinite(library.layout.unitsPerMetre))
    return fmt::format("{} units in a metre, more than 0 expected", library.layout.unitsPerMetre);
  if (std::string fault = faultIn(library.layout.still); !fault.empty()) return fault;
  if (Fault fault = faultInClips(library)) return fault;
  if (Fault fault = faultInContacts(library)) return fault;
  const Heading& facing = library.facingOffset;
  if (!isBetween(facing.sin * facing.sin + facing.cos * facing.cos, 1.0 - 1e-9, 1.0 + 1e-9))
    return std::string("a facing offset that is no unit vector");
  if (!std::isfinite(library.floorHeightMetres)) return std::string("a floor height that is not finite");
  if (Fault fault = faultInRegions(library)) return fault;
  return faultInGraph(library);
}

}  // namespace stridegraph
