#include <algorithm>
#include <utility>

#include "graph/library_builder.h"
#include "graph/library_checks.h"
#include "graph/sgraph_file.h"
#include "graph/test_library.h"
#include "input.h"
#include "math/rotation.h"
#include "text_checks.h"

namespace stridegraph::fuzz {
namespace {

/// A walk of a few dozen frames that goes as the bytes say, in places moved and turned by them.
Clip madeClip(Input& input) {
  testing::WalkShape shape;
  shape.frames = 1 + input.below(70);
  shape.speedMetresPerSecond = input.number(-0.5, 2.0);
  shape.turnPerSecond = Angle::degrees(input.number(-120.0, 120.0));
  shape.cyclesPerSecond = input.number(0.0, 2.0);
  shape.phaseCycles = input.number(0.0, 1.0);
  Clip clip = testing::walkOf(shape);
  if (input.below(8) == 7) clip.framesPerSecond = input.number(1.0, 240.0);
  for (std::size_t count = input.below(6); count > 0; --count) {
    const std::size_t frame = input.below(clip.frameCount());
    clip.rootPositions[frame] += Vec3(input.number(-5, 5), input.number(-1, 1), input.number(-5, 5));
    const std::size_t joint = input.below(clip.jointCount);
    clip.rotationsOf(frame)[joint] = axisRotation(Axis::kY, Angle::degrees(input.number(-180, 180)));
  }
  return clip;
}

std::vector<BvhDocument> madeClips(Input& input) {
  std::vector<BvhDocument> clips;
  for (std::size_t count = 1 + input.below(4); count > 0; --count) {
    clips.push_back(testing::documentOf(madeClip(input), "clip " + std::to_string(count)));
    // Rarely another body, or one without a length.
    const std::size_t change = input.below(32);
    if (change == 31) clips.back().skeleton.joints[2].offset = {0, input.number(-1, 1), 0};
    if (change == 30) clips.back().skeleton.joints[6].name = "else";
  }
  return clips;
}

LibraryParams madeParams(Input& input) {
  LibraryParams params;
  params.thresholdMetres = input.oddNumber(0.005, 0.5);
  params.transitionFrames = static_cast<std::uint32_t>(input.below(40));
  params.framesPerSecond = input.chance() ? 30.0 : input.oddNumber(1.0, 120.0);
  params.mirror = input.chance();
  params.neighbourFrames = static_cast<std::uint32_t>(input.below(110));
  params.largestSpanRatio = input.oddNumber(1.0, 2.0);
  return params;
}

void requireSound(const BuildReport& report, std::size_t clips) {
  fuzz::requireSound(report.warnings, 0);
  require(report.clips.size() >= clips, "the report names each clip");
  require(report.nodes <= report.nodesBeforePruning, "pruning adds no nodes");
  require(report.survivingShare >= 0.0 && report.survivingShare <= 1.0, "what survives is a share");
  for (const ClipFate& fate : report.clips)
    require(fate.survivingFrames <= fate.frames, "no more frames survive than there were");
}

Result<BuiltLibrary> appended(std::vector<BvhDocument> clips, const LibraryParams& params) {
  std::vector<BvhDocument> last;
  last.push_back(std::move(clips.back()));
  clips.pop_back();
  Result<BuiltLibrary> first = buildLibrary(std::move(clips), params);
  if (!first) return first;
  auto builder = LibraryBuilder::append(std::move(first->library), std::move(last));
  if (!builder) return fail(std::move(builder));
  while (builder->step()) {
  }
  BuildReport report = builder->report();
  Result<MotionLibrary> library = builder->finish();
  if (!library) return fail(std::move(library));
  return BuiltLibrary{std::move(*library), std::move(report)};
}

}  // namespace

void tryLibrary(Bytes bytes) {
  Input input(bytes);
  const LibraryParams params = madeParams(input);
  const std::vector<BvhDocument> clips = madeClips(input);
  const Result<BuiltLibrary> built = buildLibrary(clips, params);
  if (!built) return fuzz::requireSound(built.error(), 0);
  requireSound(built->report, clips.size());
  require(!faultIn(built->library), "a library that is built is sound");
  const std::vector<std::uint8_t> file = writeSgraph(built->library);
  const Result<MotionLibrary> opened = readSgraph(file);
  require(opened.has_value(), "a library that is built opens from its file");
  require(opened->hash == built->library.hash, "a library has the hash of its file");
  if (clips.size() < 2) return;
  const Result<BuiltLibrary> later = appended(clips, params);
  if (later) require(later->library.hash == built->library.hash, "appending gives the library of all clips");
}

}  // namespace stridegraph::fuzz
