#include "graph/library_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/check.h"
#include "base/utf8.h"
#include "graph/build_advice.h"
#include "graph/build_trials.h"
#include "graph/clip_faults.h"
#include "graph/clip_intake.h"
#include "graph/jerks.h"
#include "graph/library_checks.h"
#include "graph/library_connection.h"
#include "graph/library_limits.h"
#include "graph/library_notes.h"
#include "graph/pose_distance.h"
#include "graph/sgraph_file.h"
#include "graph/stages.h"
#include "graph/transition_scan.h"
#include "motion/contacts.h"
#include "motion/facing.h"

namespace stridegraph {
namespace {

ValleyParams valleyParams(const LibraryParams& params) {
  return {.thresholdMetres = params.thresholdMetres,
          .transitionFrames = params.transitionFrames,
          .neighbourFrames = params.neighbourFrames,
          .largestSpanRatio = params.largestSpanRatio};
}

std::optional<Error> faultInLicense(const std::string& license) {
  if (license.size() <= kMostLicenseBytes) return {};
  return Error{ErrorCode::kInvalidArgument, fmt::format("a licence line of {} bytes, at most {} expected",
                                                        license.size(), kMostLicenseBytes)};
}

double shareOf(std::size_t done, std::size_t all) {
  return done >= all ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
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
  std::optional<BuildTrials> trials;
  std::optional<Error> error;
  std::size_t next = 0;  ///< Clip or joint at hand in stages that go one by one.
  StageRow<State> stages;

  explicit State(ClipIntake clipIntake) : intake(std::move(clipIntake)), stages(allStages()) {}
  static std::span<const Stage<State>> allStages();

  /// Each is a stage: does a piece of it, and returns which share of it is done.
  double prepareOne();
  double checkLengths();
  double findMirror();
  double mirrorOne();
  double featuresOfOne();
  double compare();
  double jerksOfOne();
  double connect();
  double tryWhatHelps();
  double footLevelsOfOne();
  double contactsOfOne();
  double seal();

  void warnOfJerks();
  const std::vector<Clip>& clips() const { return intake.clips(); }
  /// Goes on to the next of so many clips or joints; after the last, begins anew for the next stage.
  double advance(std::size_t count) {
    if (++next < count) return shareOf(next, count);
    next = 0;
    return 1.0;
  }
  double refuse(ErrorCode code, std::string message) {
    error = Error{code, std::move(message)};
    stages.end();
    return 1.0;
  }
};

std::span<const Stage<LibraryBuilder::State>> LibraryBuilder::State::allStages() {
  // Comparing takes nearly all of the time.
  static constexpr std::array<Stage<State>, 12> kStages = {{{0.05, &State::prepareOne},
                                                            {0.00, &State::checkLengths},
                                                            {0.00, &State::findMirror},
                                                            {0.01, &State::mirrorOne},
                                                            {0.04, &State::featuresOfOne},
                                                            {0.76, &State::compare},
                                                            {0.01, &State::jerksOfOne},
                                                            {0.01, &State::connect},
                                                            {0.04, &State::tryWhatHelps},
                                                            {0.03, &State::footLevelsOfOne},
                                                            {0.03, &State::contactsOfOne},
                                                            {0.02, &State::seal}}};
  return kStages;
}

double LibraryBuilder::State::prepareOne() {
  BvhDocument& document = documents[next];
  report.warnings.insert(report.warnings.end(), document.warnings.begin(), document.warnings.end());
  intake.add(document.clip, report.warnings);
  document = {};
  return advance(documents.size());
}

double LibraryBuilder::State::checkLengths() {
  const LibraryParams& params = library.params;
  const std::size_t needed = params.transitionFrames + 2 * kWindowReach;
  std::size_t longest = 0;
  for (const Clip& clip : clips()) longest = std::max(longest, clip.frameCount());
  if (longest >= needed) return 1.0;
  const auto seconds = [&](std::size_t frames) {
    return static_cast<double>(frames) / params.framesPerSecond;
  };
  return refuse(
      ErrorCode::kClipTooShort,
      fmt::format("the longest clip has {} frames ({:.2f} s at {:.4g} a second); transitions of {} need "
                  "clips of {} ({:.2f} s) at least",
                  longest, seconds(longest), params.framesPerSecond, params.transitionFrames, needed,
                  seconds(needed)));
}

double LibraryBuilder::State::findMirror() {
  if (!library.params.mirror) return 1.0;
  if (const Result<void> found = intake.findMirror(); !found)
    return refuse(found.error().code, found.error().message);
  return 1.0;
}

double LibraryBuilder::State::mirrorOne() {
  if (!library.params.mirror) return 1.0;
  intake.addMirrorOf(next);
  return advance(intake.originals());
}

double LibraryBuilder::State::featuresOfOne() {
  if (next == 0) basis = featureBasis(library.skeleton, clips());
  features.emplace_back(library.skeleton, basis, clips()[next]);
  const double share = advance(clips().size());
  if (share == 1.0) scan.emplace(std::move(features), valleyParams(library.params), intake.takeKnown());
  return share;
}

double LibraryBuilder::State::compare() {
  const bool goesOn = scan->step();
  report.framePairs = scan->framePairs();
  if (auto fault = faultInRegionCount(scan->regionCount()))
    return refuse(ErrorCode::kInvalidArgument, *std::move(fault));
  if (!goesOn) return 1.0;
  // The last piece of work alone ends the stage.
  return std::min(scan->progress(), 0.999);
}

double LibraryBuilder::State::jerksOfOne() {
  if (next == 0) intake.collect(library);
  const std::vector<Jerk> found = findJerks(library, JointIndex(next));
  jerks.insert(jerks.end(), found.begin(), found.end());
  const double share = advance(library.skeleton.size());
  if (share == 1.0) {
    jerks = farthestByFrame(std::move(jerks));
    warnOfJerks();
  }
  return share;
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
         {clip.name},
         WarningTopic::kGraph});
  }
}

double LibraryBuilder::State::connect() {
  library.regions = scan->take();
  scan.reset();
  connectLibrary(library, jerks, report);
  const bool isEmpty = library.graph.nodes.empty();
  const bool isThinned = report.transitions < report.transitionsBeforeThinning;
  if (isEmpty) {
    trials.emplace(intake, library, jerks, BuildTrials::Params{.triesMirror = !library.params.mirror});
  } else if (report.survivingShare < kTinyShare && !isThinned) {
    trials.emplace(intake, library, jerks, BuildTrials::Params{.leastShare = kUsefulShare});
  }
  return 1.0;
}

double LibraryBuilder::State::tryWhatHelps() {
  if (trials && trials->step()) return std::min(trials->progress(), 0.999);
  const TrialFindings findings = trials ? trials->findings() : TrialFindings{};
  if (library.graph.nodes.empty())
    return refuse(ErrorCode::kEmptyGraph, adviceOnNoGraph(library, report, findings));
  trials.reset();
  const Warnings limits = limitsOf(library, report, findings);
  report.warnings.insert(report.warnings.end(), limits.begin(), limits.end());
  return 1.0;
}

double LibraryBuilder::State::footLevelsOfOne() {
  levels.push_back(jointLevelsMetres(library.skeleton, clips()[next]));
  const double share = advance(clips().size());
  if (share == 1.0) feet = findFootJoints(library.skeleton, levels);
  return share;
}

double LibraryBuilder::State::contactsOfOne() {
  const std::vector<std::uint8_t> contacts = footContacts(library.skeleton, clips()[next], feet);
  library.contacts.insert(library.contacts.end(), contacts.begin(), contacts.end());
  return advance(clips().size());
}

double LibraryBuilder::State::seal() {
  library.facingOffset = facingOffset(clips());
  library.contactJoints = feet.joints;
  library.floorHeightMetres = *std::min_element(feet.levelsMetres.begin(), feet.levelsMetres.end());
  library.hash = sgraphHash(library);
  library.notes.insert(library.notes.end(), report.warnings.begin(), report.warnings.end());
  library.notes = keepableNotes(library.notes);
  return 1.0;
}

LibraryBuilder::LibraryBuilder(std::unique_ptr<State> state) : state_(std::move(state)) {}
LibraryBuilder::LibraryBuilder(LibraryBuilder&&) noexcept = default;
LibraryBuilder& LibraryBuilder::operator=(LibraryBuilder&&) noexcept = default;
LibraryBuilder::~LibraryBuilder() = default;

Result<LibraryBuilder> LibraryBuilder::start(std::vector<BvhDocument> clips, const LibraryParams& params,
                                             std::string license) {
  if (const auto fault = faultIn(params)) return fail(ErrorCode::kInvalidArgument, *fault);
  license = toUtf8(license);
  if (auto error = faultInLicense(license)) return tl::unexpected<Error>(*std::move(error));
  for (BvhDocument& document : clips) makeTextsUtf8(document);
  if (auto error = faultInClips(clips, params)) return tl::unexpected<Error>(*std::move(error));
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
  license = toUtf8(license);
  if (auto error = faultInLicense(license)) return tl::unexpected<Error>(*std::move(error));
  for (BvhDocument& document : clips) makeTextsUtf8(document);
  if (auto error = faultInClips(clips, library)) return tl::unexpected<Error>(*std::move(error));
  MotionLibrary next;
  next.skeleton = library.skeleton;
  next.layout = library.layout;
  next.params = library.params;
  next.license = license.empty() ? library.license : std::move(license);
  next.notes = notesThatStay(library.notes);
  auto state = std::make_unique<State>(ClipIntake(std::move(library)));
  state->library = std::move(next);
  state->documents = std::move(clips);
  return LibraryBuilder(std::move(state));
}

bool LibraryBuilder::step() {
  return state_->stages.step(*state_);
}

double LibraryBuilder::progress() const {
  return state_->stages.progress();
}

Result<MotionLibrary> LibraryBuilder::finish() {
  STRIDEGRAPH_CHECK(state_->stages.isDone());
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
