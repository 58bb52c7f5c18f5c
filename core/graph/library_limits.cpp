#include "graph/library_limits.h"

#include <fmt/format.h>

#include "graph/clip_preparation.h"

namespace stridegraph {
namespace {

Error errorAt(const Clip& clip, std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {clip.name}};
}

}  // namespace

std::optional<Error> faultInAmount(std::span<const BvhDocument> clips, const LibraryParams& params,
                                   const HeldAmount& held) {
  const std::size_t images = params.mirror ? 2 : 1;
  const std::size_t clipCount = held.clips + images * clips.size();
  if (clipCount > kMostLibraryClips) {
    return Error{ErrorCode::kInvalidArgument,
                 fmt::format("found {} clips, expected at most {} in a library{}", clipCount,
                             kMostLibraryClips, params.mirror ? ", mirror images among them" : "")};
  }
  std::size_t frames = held.frames;
  for (const BvhDocument& document : clips) {
    const Clip& clip = document.clip;
    if (params.framesPerSecond > kMostFramesForOne * clip.framesPerSecond) {
      return errorAt(
          clip, fmt::format("found {:.4g} frames a second, expected at least {:.4g}: the library's {:.4g} "
                            "may be at most {} times as many",
                            clip.framesPerSecond, params.framesPerSecond / kMostFramesForOne,
                            params.framesPerSecond, kMostFramesForOne));
    }
    frames += frameCountAtLibraryRate(clip, params.framesPerSecond) * images;
    if (frames > kMostLibraryFrames) {
      return errorAt(
          clip, fmt::format("found {} frames with this clip, expected at most {} in a library (at {:.4g} "
                            "frames a second{})",
                            frames, kMostLibraryFrames, params.framesPerSecond,
                            params.mirror ? ", mirror images among them" : ""));
    }
    if (frames > kMostLibraryRotations / document.skeleton.size()) {
      return errorAt(
          clip, fmt::format("found {} frames of {} joints with this clip, expected at most {} rotations in "
                            "a library",
                            frames, document.skeleton.size(), kMostLibraryRotations));
    }
  }
  return {};
}

std::optional<std::string> faultInRegionCount(std::size_t regions) {
  if (regions <= kMostLibraryRegions) return {};
  return fmt::format(
      "found more than {} pairs of alike pieces, expected at most so many in a library; fewer or "
      "shorter clips of the same motion, a smaller threshold or more neighbours may help",
      kMostLibraryRegions);
}

}  // namespace stridegraph
