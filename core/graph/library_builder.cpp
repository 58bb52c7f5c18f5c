#include "graph/library_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "graph/clip_intake.h"
#include "graph/jerks.h"
#include "graph/library_checks.h"
#include "graph/library_connection.h"
#include "graph/library_limits.h"
#include "graph/pose_distance.h"
#include "graph/sgraph_file.h"
#include "graph/transition_scan.h"
#include "motion/contacts.h"
#include "motion/facing.h"

namespace stridegraph {
namespace {

constexpr const char* kNoClips = "no clips, at least one expected";

enum class Stage {
  kPrepare,
  kMeasure,
  kLevel,
  kMirror,
  kFeatures,
  kScan,
  kJerks,
  kConnect,
  kLevels,
  kContacts,
  kSeal,
  kDone
};

ValleyParams valleyParams(const LibraryParams& params) {
  return {.thresholdMetres = params.thresholdMetres,
          .transitionFrames = params.transitionFrames,
          .neighbourFrames = params.neighbourFrames,
          .largestSpanRatio = params.largestSpanRatio};
}

/// What a clip's skeleton has to be, and whose that is.
struct ExpectedSkeleton {
  const Skeleton& skeleton;
  std::string owner;
};

std::optional<Error> faultInClip(const BvhDocument& document, const ExpectedSkeleton& expected) {
  const std::string& name = document.clip.name;
  if (const auto fault = faultIn(document.skeleton))
    return Error{ErrorCode::kInvalidArgument, *fault, {name}};
  const std::string difference = differenceBetween(expected.skeleton, document.skeleton);
  if (!difference.empty())
    return Error{ErrorCode::kSkeletonMismatch,
                 fmt::format("its skeleton is not that of {}: {}", expected.owner, difference),
                 {name}};
  if (const auto fault = faultIn(document.skeleton, document.clip))
    return Error{ErrorCode::kInvalidArgument, *fault, {name}};
  if (document.clip.frameCount() == 0)
    return Error{ErrorCode::kInvalidArgument, "a clip without frames", {name}};
  return {};
}

std::optional<Error> faultInClips(const std::vector<BvhDocument>& clips, const ExpectedSkeleton& expected) {
  for (const BvhDocument& document : clips) {
    if (auto error = faultInClip(document, expected)) return error;
  }
  return {};
}

}  // namespace

struct LibraryBuilder::State {
  std::vector<BvhDocument> documents;
  MotionLibrary library;
  BuildReport report;
  ClipIntake intake;
  std::vector<std::vector<double>> levels;  ///< jointLevelsMetres() of each clip.
  FootJoints feet;
  FeatureBasis basis;
  std::vector<ClipFeatures> features;
  std::optional<TransitionScan> scan;
  std::vector<Jerk> jerks;
  std::optional<Error> error;
  Stage stage = Stage::kPrepare;
  std::size_t next = 0;  ///< Clip at hand in stages that go clip by clip.

  explicit State(ClipIntake clipIntake) : intake(std::move(clipIntake)) {}
  void prepareOne();
  void measure();
  void levelOne();
  void mirrorOne();
  void featuresOfOne();
  void scanSome();
  void jerksOfOne();
  void warnOfJerks();
  void connect();
  void collectFrames();
  void levelsOfOne();
  void contactsOfOne();
  void seal();
  const std::vector<Clip>& clips() const { return intake.clips(); }
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
  intake.add(document.clip, report.warnings);
  document = {};
  if (++next == documents.size()) enter(Stage::kMeasure);
}

void LibraryBuilder::State::measure() {
  const std::size_t needed = library.params.transitionFrames + 2 * kWindowReach;
  std::size_t longest = 0;
  for (const Clip& clip : clips()) longest = std::max(longest, clip.frameCount());
  if (longest < needed)
    return refuse(ErrorCode::kClipTooShort,
                  fmt::format("the longest clip has {} frames; transitions of {} need clips of {} at least",
                              longest, library.params.transitionFrames, needed));
  enter(Stage::kLevel);
}

void LibraryBuilder::State::levelOne() {
  intake.level(next, report.warnings);
  if (++next < clips().size()) return;
  if (!library.params.mirror) return enter(Stage::kFeatures);
  if (const Result<void> found = intake.findMirror(); !found)
    return refuse(found.error().code, found.error().message);
  enter(Stage::kMirror);
}

void LibraryBuilder::State::mirrorOne() {
  intake.addMirrorOf(next);
  if (++next == intake.originals()) enter(Stage::kFeatures);
}

void LibraryBuilder::State::featuresOfOne() {
  if (next == 0) basis = featureBasis(library.skeleton, clips());
  features.emplace_back(library.skeleton, basis, clips()[next]);
  if (++next < clips().size()) return;
  scan.emplace(std::move(features), valleyParams(library.params), intake.takeKnown());
  enter(Stage::kScan);
}

void LibraryBuilder::State::scanSome() {
  const bool goesOn = scan->step();
  report.framePairs = scan->framePairs();
  if (auto fault = faultInRegionCount(scan->regionCount()))
    return refuse(ErrorCode::kInvalidArgument, *std::move(fault));
  if (!goesOn) enter(Stage::kJerks);
}

void LibraryBuilder::State::collectFrames() {
  library.frames.framesPerSecond = library.params.framesPerSecond;
  library.frames.jointCount = library.skeleton.size();
  for (std::size_t c = 0; c < clips().size(); ++c) {
    const Clip& clip = clips()[c];
    library.clips.push_back({clip.name, static_cast<std::uint32_t>(library.frames.frameCount()),
                             static_cast<std::uint32_t>(clip.frameCount()), intake.isMirrored(c)});
    for (std::size_t f = 0; f < clip.frameCount(); ++f) library.frames.append(clip.pose(f));
  }
}

void LibraryBuilder::State::levelsOfOne() {
  levels.push_back(jointLevelsMetres(library.skeleton, clips()[next]));
  if (++next < clips().size()) return;
  feet = findFootJoints(library.skeleton, levels);
  enter(Stage::kContacts);
}

void LibraryBuilder::State::contactsOfOne() {
  const std::vector<std::uint8_t> contacts = footContacts(library.skeleton, clips()[next], feet);
  library.contacts.insert(library.contacts.end(), contacts.begin(), contacts.end());
  if (++next == clips().size()) enter(Stage::kSeal);
}

void LibraryBuilder::State::seal() {
  library.facingOffset = facingOffset(clips());
  library.contactJoints = feet.joints;
  library.floorHeightMetres = *std::min_element(feet.levelsMetres.begin(), feet.levelsMetres.end());
  library.hash = sgraphHash(library);
  enter(Stage::kDone);
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
  library.regions = scan->take();
  const Result<void> connected = connectLibrary(library, jerks, report);
  if (!connected) return refuse(connected.error().code, connected.error().message);
  enter(Stage::kLevels);
}

LibraryBuilder::LibraryBuilder(std::unique_ptr<State> state) : state_(std::move(state)) {}
LibraryBuilder::LibraryBuilder(LibraryBuilder&&) noexcept = default;
LibraryBuilder& LibraryBuilder::operator=(LibraryBuilder&&) noexcept = default;
LibraryBuilder::~LibraryBuilder() = default;

Result<LibraryBuilder> LibraryBuilder::start(std::vector<BvhDocument> clips, const LibraryParams& params,
                                             std::string license) {
  if (const auto fault = faultIn(params)) return fail(ErrorCode::kInvalidArgument, *fault);
  if (clips.empty()) return fail(ErrorCode::kInvalidArgument, kNoClips);
  if (auto error = faultInClips(clips, {clips.front().skeleton, clips.front().clip.name}))
    return tl::unexpected<Error>(*std::move(error));
  if (auto error = faultInAmount(clips, params, 0)) return tl::unexpected<Error>(*std::move(error));
  auto state = std::make_unique<State>(ClipIntake(clips.front().skeleton, params));
  state->library.skeleton = clips.front().skeleton;
  state->library.layout = clips.front().layout;
  state->library.params = params;
  state->library.license = std::move(license);
  state->documents = std::move(clips);
  return LibraryBuilder(std::move(state));
}

Result<LibraryBuilder> LibraryBuilder::append(MotionLibrary library, std::vector<BvhDocument> clips,
                                              std::string license) {
  if (clips.empty()) return fail(ErrorCode::kInvalidArgument, kNoClips);
  if (auto error = faultInClips(clips, {library.skeleton, "the library"}))
    return tl::unexpected<Error>(*std::move(error));
  if (auto error = faultInAmount(clips, library.params, library.frames.frameCount()))
    return tl::unexpected<Error>(*std::move(error));
  MotionLibrary next;
  next.skeleton = library.skeleton;
  next.layout = library.layout;
  next.params = library.params;
  next.license = license.empty() ? library.license : std::move(license);
  auto state = std::make_unique<State>(ClipIntake(std::move(library)));
  state->library = std::move(next);
  state->documents = std::move(clips);
  return LibraryBuilder(std::move(state));
}

bool LibraryBuilder::step() {
  State& state = *state_;
  switch (state.stage) {
    case Stage::kPrepare:
      state.prepareOne();
      break;
    case Stage::kMeasure:
      state.measure();
      break;
    case Stage::kLevel:
      state.levelOne();
      break;
    case Stage::kMirror:
      state.mirrorOne();
      break;
    case Stage::kFeatures:
      state.featuresOfOne();
      break;
    case Stage::kScan:
      state.scanSome();
      break;
    case Stage::kJerks:
      state.jerksOfOne();
      break;
    case Stage::kConnect:
      state.connect();
      break;
    case Stage::kLevels:
      state.levelsOfOne();
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
    case Stage::kMeasure:
      return 0.04;
    case Stage::kLevel:
      return 0.04 + 0.01 * share(state_->clips().size());
    case Stage::kMirror:
      return 0.05;
    case Stage::kFeatures:
      return 0.05 + 0.05 * share(state_->clips().size());
    case Stage::kScan:
      return 0.1 + 0.8 * state_->scan->progress();
    case Stage::kJerks:
      return 0.9 + 0.01 * share(state_->library.skeleton.size());
    case Stage::kConnect:
      return 0.91;
    case Stage::kLevels:
      return 0.92 + 0.03 * share(state_->clips().size());
    case Stage::kContacts:
      return 0.95 + 0.03 * share(state_->clips().size());
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
