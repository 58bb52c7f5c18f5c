#include "graph/library_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "graph/clip_preparation.h"
#include "graph/glitches.h"
#include "graph/graph_building.h"
#include "graph/jerks.h"
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

enum class Stage {
  kPrepare,
  kFindFeet,
  kLevel,
  kMirror,
  kFeatures,
  kScan,
  kJerks,
  kConnect,
  kContacts,
  kSeal,
  kDone
};

ValleyParams valleyParams(const LibraryParams& params) {
  return {.thresholdMetres = params.thresholdMetres,
          .transitionFrames = params.transitionFrames,
          .neighbourFrames = params.neighbourFrames};
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
  std::vector<bool> mirrored;               ///< For each of the clips,
  std::vector<std::vector<double>> levels;  ///< and jointLevelsMetres().
  std::vector<double> floors;               ///< For each clip that is no mirror image, floorLevelMetres().
  FootJoints feet;
  FeatureBasis basis;
  std::vector<ClipFeatures> features;
  std::optional<TransitionScan> scan;
  std::vector<Jerk> jerks;
  std::optional<Error> error;
  Stage stage = Stage::kPrepare;
  std::size_t next = 0;  ///< Clip at hand in stages that go clip by clip.

  void prepareOne();
  void findFeet();
  void floorOfOne();
  void level();
  void mirrorOne();
  void featuresOfOne();
  void jerksOfOne();
  void warnOfJerks();
  void connect();
  void addClip(Clip clip, bool isMirrored);
  void collectFrames();
  void contactsOfOne();
  void seal();
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
  for (Clip& piece : cutAtGlitches(clip, glitches)) addClip(std::move(piece), false);
  document = {};
  if (++next == documents.size()) enter(Stage::kFindFeet);
}

void LibraryBuilder::State::addClip(Clip clip, bool isMirrored) {
  roundToFloats(library.skeleton, clip);
  levels.push_back(jointLevelsMetres(library.skeleton, clip));
  clips.push_back(std::move(clip));
  mirrored.push_back(isMirrored);
}

void LibraryBuilder::State::findFeet() {
  const std::size_t needed = library.params.transitionFrames + 2 * kWindowReach;
  std::size_t longest = 0;
  for (const Clip& clip : clips) longest = std::max(longest, clip.frameCount());
  if (longest < needed)
    return refuse(ErrorCode::kClipTooShort,
                  fmt::format("the longest clip has {} frames; transitions of {} need clips of {} at least",
                              longest, library.params.transitionFrames, needed));
  feet = findFootJoints(library.skeleton, levels);
  enter(Stage::kLevel);
}

void LibraryBuilder::State::floorOfOne() {
  floors.push_back(floorLevelMetres(library.skeleton, clips[next], feet.joints));
  if (++next == clips.size()) level();
}

void LibraryBuilder::State::level() {
  const std::vector<double> lifts = floorLiftsMetres(floors);
  for (std::size_t c = 0; c < clips.size(); ++c) {
    if (lifts[c] == 0.0) continue;
    for (Vec3& root : clips[c].rootPositions) root.y() += lifts[c];
    roundToFloats(library.skeleton, clips[c]);
    for (double& ofJoint : levels[c]) ofJoint += lifts[c];
    report.warnings.push_back(liftWarning(clips[c].name, lifts[c]));
  }
  if (!library.params.mirror) return enter(Stage::kFeatures);
  Result<MirrorMap> map = findMirrorMap(library.skeleton, clips);
  if (!map) return refuse(map.error().code, map.error().message);
  mirrorMap = std::move(*map);
  enter(Stage::kMirror);
}

void LibraryBuilder::State::mirrorOne() {
  Clip mirror = stridegraph::mirrored(library.skeleton, *mirrorMap, clips[next]);
  mirror.name = clips[next].name + " mirrored";
  addClip(std::move(mirror), true);
  if (2 * ++next == clips.size()) enter(Stage::kFeatures);
}

void LibraryBuilder::State::featuresOfOne() {
  if (next == 0) basis = featureBasis(library.skeleton, clips);
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

void LibraryBuilder::State::contactsOfOne() {
  if (next == 0) feet = findFootJoints(library.skeleton, levels);
  const std::vector<std::uint8_t> contacts = footContacts(library.skeleton, clips[next], feet);
  library.contacts.insert(library.contacts.end(), contacts.begin(), contacts.end());
  if (++next == clips.size()) enter(Stage::kSeal);
}

void LibraryBuilder::State::seal() {
  library.facingOffset = facingOffset(clips);
  library.contactJoints = feet.joints;
  library.floorHeightMetres = *std::min_element(feet.levelsMetres.begin(), feet.levelsMetres.end());
  library.hash = sgraphHash(library);
  enter(Stage::kDone);
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

void LibraryBuilder::State::jerksOfOne() {
  if (next == 0) collectFrames();
  const std::vector<Jerk> found = findJerks(library, JointIndex(next));
  jerks.insert(jerks.end(), found.begin(), found.end());
  if (++next < library.skeleton.size()) return;
  jerks = farthestByFrame(std::move(jerks));
  warnOfJerks();
  enter(Stage::kConnect);
}

void LibraryBuilder::State::warnOfJerks() {
  for (const Jerk& jerk : jerks) {
    const LibraryClip& clip = library.clipOf(jerk.frame);
    if (clip.mirrored) continue;
    const std::uint32_t frame = jerk.frame.value - clip.firstFrame;
    report.warnings.push_back(
        {fmt::format("joint {} slips by {:.0f} degrees from frame {} to {}, more than "
                     "it turns anywhere else: nothing plays across that",
                     library.skeleton.joints[jerk.joint.value].name, jerk.turn.degrees(), frame, frame + 1),
         {clip.name}});
  }
}

void LibraryBuilder::State::connect() {
  const std::vector<FoundTransition> found = scan->take();
  std::vector<FrameTransition> transitions = edgesFrom(found);
  std::erase_if(transitions, [&](const FrameTransition& one) { return blendsAcross(jerks, one); });
  const MotionGraph whole = buildGraph(steadyFrameCounts(library, jerks), transitions);
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
  enter(Stage::kContacts);
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
    case Stage::kFindFeet:
      state.findFeet();
      break;
    case Stage::kLevel:
      state.floorOfOne();
      break;
    case Stage::kMirror:
      state.mirrorOne();
      break;
    case Stage::kFeatures:
      state.featuresOfOne();
      break;
    case Stage::kScan:
      if (!state.scan->step()) state.enter(Stage::kJerks);
      break;
    case Stage::kJerks:
      state.jerksOfOne();
      break;
    case Stage::kConnect:
      state.connect();
      break;
    case Stage::kContacts:
      state.contactsOfOne();
      break;
    case Stage::kSeal:
      state.seal();
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
      return 0.04 * share(state_->documents.size());
    case Stage::kFindFeet:
      return 0.04;
    case Stage::kLevel:
      return 0.04 + 0.01 * share(state_->clips.size());
    case Stage::kMirror:
      return 0.05;
    case Stage::kFeatures:
      return 0.05 + 0.05 * share(state_->clips.size());
    case Stage::kScan:
      return 0.1 + 0.8 * state_->scan->progress();
    case Stage::kJerks:
      return 0.9 + 0.01 * share(state_->library.skeleton.size());
    case Stage::kConnect:
      return 0.91;
    case Stage::kContacts:
      return 0.92 + 0.06 * share(state_->clips.size());
    case Stage::kSeal:
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
