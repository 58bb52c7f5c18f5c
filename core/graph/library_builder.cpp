#include "graph/library_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "graph/clip_preparation.h"
#include "graph/glitches.h"
#include "graph/graph_building.h"
#include "graph/library_checks.h"
#include "graph/pose_distance.h"
#include "graph/sgraph_file.h"
#include "graph/survival.h"
#include "graph/transition_scan.h"
#include "motion/contacts.h"
#include "motion/facing.h"
#include "motion/mirror.h"
#include "motion/mirror_map.h"

namespace stridegraph {
namespace {

enum class Stage { kPrepare, kLevel, kMirror, kFeatures, kScan, kConnect, kDone };

ValleyParams valleyParams(const LibraryParams& params) {
  return {.thresholdMetres = params.thresholdMetres, .transitionFrames = params.transitionFrames};
}

std::optional<Error> faultInClip(const BvhDocument& document, const BvhDocument& first) {
  const std::string& name = document.clip.name;
  if (const auto fault = faultIn(document.skeleton))
    return Error{ErrorCode::kInvalidArgument, *fault, {name}};
  const std::string difference = differenceBetween(first.skeleton, document.skeleton);
  if (!difference.empty())
    return Error{ErrorCode::kSkeletonMismatch,
                 fmt::format("its skeleton is not that of {}: {}", first.clip.name, difference),
                 {name}};
  if (const auto fault = faultIn(document.skeleton, document.clip))
    return Error{ErrorCode::kInvalidArgument, *fault, {name}};
  if (document.clip.frameCount() == 0)
    return Error{ErrorCode::kInvalidArgument, "a clip without frames", {name}};
  return {};
}

}  // namespace

struct LibraryBuilder::State {
  std::vector<BvhDocument> documents;
  MotionLibrary library;
  BuildReport report;
  std::optional<MirrorMap> mirrorMap;
  std::vector<Clip> clips;
  std::vector<bool> mirrored;  ///< For each of the clips.
  FeatureBasis basis;
  std::vector<ClipFeatures> features;
  std::optional<TransitionScan> scan;
  std::optional<Error> error;
  Stage stage = Stage::kPrepare;
  std::size_t next = 0;  ///< Clip at hand in stages that go clip by clip.

  void prepareOne();
  void level();
  void mirrorOne();
  void featuresOfOne();
  void connect();
  void collectFrames();
  void analyseFeet();
  std::vector<FrameTransition> edgesFrom(const std::vector<FoundTransition>& found) const;
  void countGraph(const MotionGraph& whole);
  void enter(Stage following) {
    stage = following;
    next = 0;
  }
  void refuse(ErrorCode code, std::string message) {
    error = Error{code, std::move(message)};
    stage = Stage::kDone;
  }
};

void LibraryBuilder::State::prepareOne() {
  BvhDocument& document = documents[next];
  report.warnings.insert(report.warnings.end(), document.warnings.begin(), document.warnings.end());
  const Clip clip = atLibraryRate(document.clip, library.params.framesPerSecond);
  const std::vector<Glitch> glitches = findGlitches(clip);
  for (const Glitch& glitch : glitches) {
    report.warnings.push_back(
        {fmt::format("joint {} turns {:.0f} degrees from frame {} to {}, far more than before and "
                     "after: cut there",
                     library.skeleton.joints[glitch.joint.value].name, glitch.turn.degrees(), glitch.frame,
                     glitch.frame + 1),
         {clip.name}});
  }
  for (Clip& piece : cutAtGlitches(clip, glitches)) clips.push_back(std::move(piece));
  document = {};
  if (++next == documents.size()) enter(Stage::kLevel);
}

void LibraryBuilder::State::level() {
  const std::size_t needed = library.params.transitionFrames + 2 * kWindowReach;
  std::size_t longest = 0;
  for (const Clip& clip : clips) longest = std::max(longest, clip.frameCount());
  if (longest < needed)
    return refuse(ErrorCode::kClipTooShort,
                  fmt::format("the longest clip has {} frames; transitions of {} need clips of {} at least",
                              longest, library.params.transitionFrames, needed));
  const Warnings warnings = levelFloors(library.skeleton, clips);
  report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  mirrored.assign(clips.size(), false);
  if (!library.params.mirror) return enter(Stage::kFeatures);
  Result<MirrorMap> map = findMirrorMap(library.skeleton, clips);
  if (!map) return refuse(map.error().code, map.error().message);
  mirrorMap = std::move(*map);
  enter(Stage::kMirror);
}

void LibraryBuilder::State::mirrorOne() {
  Clip mirror = stridegraph::mirrored(library.skeleton, *mirrorMap, clips[next]);
  mirror.name = clips[next].name + " mirrored";
  clips.push_back(std::move(mirror));
  mirrored.push_back(true);
  if (2 * ++next == clips.size()) enter(Stage::kFeatures);
}

void LibraryBuilder::State::featuresOfOne() {
  if (next == 0) {
    for (Clip& clip : clips) roundToFloats(library.skeleton, clip);
    basis = featureBasis(library.skeleton, clips);
  }
  features.emplace_back(library.skeleton, basis, clips[next]);
  if (++next < clips.size()) return;
  scan.emplace(std::move(features), valleyParams(library.params));
  enter(Stage::kScan);
}

void LibraryBuilder::State::collectFrames() {
  library.frames.framesPerSecond = library.params.framesPerSecond;
  library.frames.jointCount = library.skeleton.size();
  for (std::size_t c = 0; c < clips.size(); ++c) {
    library.clips.push_back({clips[c].name, static_cast<std::uint32_t>(library.frames.frameCount()),
                             static_cast<std::uint32_t>(clips[c].frameCount()), mirrored[c]});
    for (std::size_t f = 0; f < clips[c].frameCount(); ++f) library.frames.append(clips[c].pose(f));
  }
}

void LibraryBuilder::State::analyseFeet() {
  library.facingOffset = facingOffset(clips);
  const FootJoints feet = findFootJoints(library.skeleton, clips);
  library.contactJoints = feet.joints;
  library.floorHeightMetres = *std::min_element(feet.levelsMetres.begin(), feet.levelsMetres.end());
  for (const Clip& clip : clips) {
    const std::vector<std::uint8_t> contacts = footContacts(library.skeleton, clip, feet);
    library.contacts.insert(library.contacts.end(), contacts.begin(), contacts.end());
  }
}

std::vector<FrameTransition> LibraryBuilder::State::edgesFrom(
    const std::vector<FoundTransition>& found) const {
  const std::uint32_t span = library.params.transitionFrames - 1;
  std::vector<FrameTransition> edges;
  for (const FoundTransition& transition : found) {
    edges.push_back({FrameIndex(library.clips[transition.from.clip].firstFrame + transition.from.frame),
                     FrameIndex(library.clips[transition.to.clip].firstFrame + transition.to.frame), span,
                     span, span, static_cast<float>(transition.meanDistanceMetres)});
  }
  return edges;
}

void LibraryBuilder::State::countGraph(const MotionGraph& whole) {
  report.framePairs = scan->framePairs();
  report.nodesBeforePruning = whole.nodes.size();
  report.clipPiecesBeforePruning = whole.clipPieceCount();
  report.transitionsBeforePruning = whole.transitionCount();
  report.nodes = library.graph.nodes.size();
  report.clipPieces = library.graph.clipPieceCount();
  report.transitions = library.graph.transitionCount();
  std::size_t surviving = 0;
  for (const ClipFate& fate : report.clips) surviving += fate.survivingFrames;
  report.survivingShare = static_cast<double>(surviving) / static_cast<double>(library.frames.frameCount());
}

void LibraryBuilder::State::connect() {
  collectFrames();
  const std::vector<FoundTransition> found = scan->take();
  std::vector<std::uint32_t> counts;
  for (const LibraryClip& clip : library.clips) counts.push_back(clip.frameCount);
  const MotionGraph whole = buildGraph(counts, edgesFrom(found));
  library.graph = withoutPassThroughNodes(largestStronglyConnectedPart(whole));
  report.clips = clipFates(library, found);
  countGraph(whole);
  if (library.graph.nodes.empty())
    return refuse(
        ErrorCode::kEmptyGraph,
        fmt::format(
            "{} transitions were found within {} m, but no walk along them could go on for ever; more "
            "clips, a larger threshold, shorter transitions or mirroring may help",
            found.size(), library.params.thresholdMetres));
  analyseFeet();
  library.hash = sgraphHash(library);
  enter(Stage::kDone);
}

LibraryBuilder::LibraryBuilder(std::unique_ptr<State> state) : state_(std::move(state)) {}
LibraryBuilder::LibraryBuilder(LibraryBuilder&&) noexcept = default;
LibraryBuilder& LibraryBuilder::operator=(LibraryBuilder&&) noexcept = default;
LibraryBuilder::~LibraryBuilder() = default;

Result<LibraryBuilder> LibraryBuilder::start(std::vector<BvhDocument> clips, const LibraryParams& params,
                                             std::string license) {
  if (const auto fault = faultIn(params)) return fail(ErrorCode::kInvalidArgument, *fault);
  if (clips.empty()) return fail(ErrorCode::kInvalidArgument, "no clips, at least one expected");
  for (const BvhDocument& document : clips) {
    if (auto error = faultInClip(document, clips.front())) return tl::unexpected<Error>(std::move(*error));
  }
  auto state = std::make_unique<State>();
  state->library.skeleton = clips.front().skeleton;
  state->library.layout = clips.front().layout;
  state->library.params = params;
  state->library.license = std::move(license);
  state->documents = std::move(clips);
  return LibraryBuilder(std::move(state));
}

bool LibraryBuilder::step() {
  State& state = *state_;
  switch (state.stage) {
    case Stage::kPrepare:
      state.prepareOne();
      break;
    case Stage::kLevel:
      state.level();
      break;
    case Stage::kMirror:
      state.mirrorOne();
      break;
    case Stage::kFeatures:
      state.featuresOfOne();
      break;
    case Stage::kScan:
      if (!state.scan->step()) state.enter(Stage::kConnect);
      break;
    case Stage::kConnect:
      state.connect();
      break;
    case Stage::kDone:
      break;
  }
  return state.stage != Stage::kDone;
}

double LibraryBuilder::progress() const {
  // Comparing takes nearly all of the time; what comes before gets a tenth.
  const auto share = [&](std::size_t of) {
    return static_cast<double>(state_->next) / static_cast<double>(of);
  };
  switch (state_->stage) {
    case Stage::kPrepare:
      return 0.05 * share(state_->documents.size());
    case Stage::kLevel:
    case Stage::kMirror:
      return 0.05;
    case Stage::kFeatures:
      return 0.05 + 0.05 * share(state_->clips.size());
    case Stage::kScan:
      return 0.1 + 0.88 * state_->scan->progress();
    case Stage::kConnect:
      return 0.98;
    case Stage::kDone:
      break;
  }
  return 1.0;
}

Result<MotionLibrary> LibraryBuilder::finish() {
  STRIDEGRAPH_CHECK(state_->stage == Stage::kDone);
  if (state_->error) return tl::unexpected<Error>(*state_->error);
  return std::move(state_->library);
}

const BuildReport& LibraryBuilder::report() const {
  return state_->report;
}

Result<BuiltLibrary> buildLibrary(std::vector<BvhDocument> clips, const LibraryParams& params,
                                  std::string license) {
  Result<LibraryBuilder> builder = LibraryBuilder::start(std::move(clips), params, std::move(license));
  if (!builder) return fail(std::move(builder));
  while (builder->step()) {
  }
  Result<MotionLibrary> library = builder->finish();
  if (!library) return fail(std::move(library));
  return BuiltLibrary{std::move(*library), builder->report()};
}

}  // namespace stridegraph
