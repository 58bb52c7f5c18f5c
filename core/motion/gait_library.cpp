#include "motion/gait_library.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/check.h"
#include "motion/gait_synthesis.h"

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;

/// Before and after whatever a clip shows: 15 frames that no transition reaches, the smoothing of a change,
/// and a few frames of steady going to join at.
constexpr double kLeadSeconds = 1.0;

/// Half the time in which a walker slows down for a turn.
constexpr double kTurnSpeedBlend = 0.35;

/// Phases at which the feet pass each other: where a stand begins and ends.
constexpr double kLeftCarries = 0.5 * kPi;
constexpr double kRightCarries = 1.5 * kPi;

/// How a turn is walked: people slow down for a tight one, else they would lean and cross their feet.
struct Turning {
  double straightSpeed;  ///< m/s, before and after
  double turnSpeed;      ///< m/s
  double turnRate;       ///< rad/s
  Gait gait = Gait::kWalk;
};

/// Collects clips; a request for the left side brings its mirror image along.
class Collector {
 public:
  /// Every request has steps of its own.
  void add(GaitRequest request) {
    request.seed = ++seed_;
    append(request);
  }

  /// "name_left" as asked and "name_right" mirrored.
  void addBothHands(GaitRequest request) {
    const std::string name = request.name;
    request.seed = ++seed_;
    request.name = name + "_left";
    append(request);
    request.name = name + "_right";
    for (GaitSegment& segment : request.segments) segment.turnRate = -segment.turnRate;
    if (!request.startPhase && !request.endPhase) request.startPhase = 0.0;
    if (request.startPhase) *request.startPhase += kPi;
    if (request.endPhase) *request.endPhase += kPi;
    append(request);
  }

  std::vector<Clip> take() { return std::move(clips_); }

 private:
  void append(const GaitRequest& request) {
    Result<Clip> clip = synthesiseGait(request);
    STRIDEGRAPH_CHECK(clip.has_value());
    clips_.push_back(std::move(*clip));
  }

  std::vector<Clip> clips_;
  std::uint64_t seed_ = 0;
};

/// Which foot carries in the middle of a turn, or which one the weight goes over to just then: quarters of
/// the gait cycle, in their order.
enum class Middle { kInnerFoot, kOntoOuterFoot, kOuterFoot, kOntoInnerFoot };

/// With a turn for each of these a walker can begin to turn every 0.3 m, a quarter of a double step.
constexpr std::array<std::pair<Middle, const char*>, 4> kMiddles = {
    {{Middle::kOuterFoot, ""},
     {Middle::kOntoInnerFoot, "_onto_inner_foot"},
     {Middle::kInnerFoot, "_inner_foot"},
     {Middle::kOntoOuterFoot, "_onto_outer_foot"}}};

/// Sets the phase at the beginning so that the feet are as asked in the middle of the request, a turn to the
/// left.
void placeFeet(Middle wanted, GaitRequest& request) {
  request.startPhase = 0.0;
  const Result<GaitTrack> track = layTrack(request);
  STRIDEGRAPH_CHECK(track.has_value());
  const GaitMoment& middle = track->moments[track->moments.size() / 2];
  const double leftCarries = contactAt(middle).middle();
  request.startPhase = leftCarries + 0.5 * kPi * static_cast<double>(wanted) - middle.phase;
}

/// Straight, a turn to the left, straight. The radius is the speed in the turn by its rate.
GaitRequest turn(std::string name, double degrees, const Turning& how, Middle middle) {
  const double seconds = degrees * kPi / 180.0 / how.turnRate;
  const GaitSegment straight{kLeadSeconds, how.straightSpeed, 0.0, how.gait};
  GaitRequest request;
  request.name = std::move(name);
  request.segments = {straight, {seconds, how.turnSpeed, how.turnRate, how.gait}, straight};
  request.speedBlendSeconds = kTurnSpeedBlend;
  placeFeet(middle, request);
  return request;
}

GaitRequest sequence(std::string name, std::vector<GaitSegment> segments) {
  GaitRequest request;
  request.name = std::move(name);
  request.segments = std::move(segments);
  return request;
}

void addStraightWalks(Collector& clips) {
  clips.add(sequence("walk_0.8", {{2.7, 0.8}}));
  clips.add(sequence("walk_1.0", {{3.4, 1.0}}));
  // Long, so that whoever walks straight on need not change clips every two metres, nor his pace.
  clips.add(sequence("walk_1.3", {{7.0, 1.3}}));
  clips.add(sequence("walk_1.5", {{2.5, 1.5}}));
  clips.add(sequence("walk_1.7", {{2.5, 1.7}}));
  clips.add(sequence("walk_speeds",
                     {{1.2, 0.8}, {1.2, 1.0}, {1.2, 1.3}, {1.2, 1.7}, {1.2, 1.3}, {1.2, 1.0}, {1.2, 0.8}}));
}

/// Walking turns as tight as they go without crossing the feet much: of 0.44 and 0.48 m, so that a body 0.4 m
/// wide stays close to the corner that it goes around.
void addTightTurns(Collector& clips) {
  const Turning brisk{1.15, 0.8, 1.8};
  const Turning careful{1.15, 0.75, 1.55};
  for (const auto& [middle, suffix] : kMiddles) {
    const auto add = [&clips, middle = middle, suffix = suffix](int degrees, const Turning& how) {
      clips.addBothHands(turn("walk_tight_" + std::to_string(degrees) + suffix, degrees, how, middle));
    };
    add(45, brisk);
    add(90, middle == Middle::kInnerFoot ? careful : brisk);
    // A half turn in the middle of which the outer foot carries would cross the feet.
    add(middle == Middle::kOuterFoot ? 135 : 180, careful);
  }
}

void addTurns(Collector& clips) {
  addTightTurns(clips);
  clips.addBothHands(turn("walk_wide_90", 90, {1.3, 1.25, 1.1}, Middle::kInnerFoot));
  const double sway = 40.0 * kPi / 180.0;
  clips.add(sequence("walk_slalom", {{kLeadSeconds, 1.2},
                                     {1.0, 1.2, sway},
                                     {2.0, 1.2, -sway},
                                     {2.0, 1.2, sway},
                                     {1.0, 1.2, -sway},
                                     {kLeadSeconds, 1.2}}));
}

void addStanding(Collector& clips) {
  GaitRequest idle = sequence("stand", {{3.2, 0.0}});
  idle.startPhase = kLeftCarries;
  clips.add(idle);
  for (const auto& [name, speed] : {std::pair{"", 1.0}, {"_briskly", 1.4}}) {
    GaitRequest start = sequence(std::string("start") + name, {{1.5, 0.0}, {1.8, speed}});
    start.startPhase = kLeftCarries;
    clips.addBothHands(start);
    GaitRequest stop = sequence(std::string("stop") + name, {{1.7, speed}, {1.6, 0.0}});
    stop.endPhase = kRightCarries;
    clips.addBothHands(stop);
  }
  // Who is to go elsewhere than where he looks turns first: a curve from a stand leads away from there.
  for (const int degrees : {45, 90, 135}) {
    const double seconds = degrees * kPi / 180.0 / 1.5;
    GaitRequest start = sequence("start_turned_" + std::to_string(degrees),
                                 {{1.4, 0.0}, {seconds, 0.1, 1.5}, {kLeadSeconds + 0.3, 1.15}});
    start.speedBlendSeconds = kTurnSpeedBlend;
    start.startPhase = kRightCarries;
    clips.addBothHands(start);
  }
  for (const int degrees : {90, 180}) {
    GaitRequest spot =
        turn("turn_on_the_spot_" + std::to_string(degrees), degrees, {0.0, 0.0, 1.25}, Middle::kOuterFoot);
    spot.startPhase = kLeftCarries;
    clips.addBothHands(spot);
  }
}

void addJogs(Collector& clips) {
  clips.add(sequence("jog_2.3", {{2.2, 2.3, 0.0, Gait::kJog}}));
  clips.add(sequence("jog_2.5", {{2.2, 2.5, 0.0, Gait::kJog}}));
  clips.add(sequence("jog_2.8", {{3.0, 2.8, 0.0, Gait::kJog}}));
  clips.add(sequence("jog_3.0", {{3.0, 3.0, 0.0, Gait::kJog}}));
  clips.addBothHands(turn("jog_90", 90, {2.5, 2.4, 1.2, Gait::kJog}, Middle::kOuterFoot));
  clips.add(sequence("walk_to_jog", {{1.6, 1.5}, {1.8, 2.4, 0.0, Gait::kJog}}));
  clips.add(sequence("jog_to_walk", {{1.6, 2.4, 0.0, Gait::kJog}, {1.8, 1.5}}));
}

}  // namespace

std::vector<Clip> defaultGaitClips() {
  Collector clips;
  addStraightWalks(clips);
  addTurns(clips);
  addStanding(clips);
  addJogs(clips);
  return clips.take();
}

std::vector<Clip> thesisGaitPair() {
  const auto jog = [](double frames, double turnDegrees = 0.0) {
    const double seconds = frames / 30.0;
    return GaitSegment{seconds, 2.8, turnDegrees * kPi / 180.0 / seconds, Gait::kJog};
  };
  Collector clips;
  for (GaitRequest request :
       {sequence("thesis_straight_jog", {jog(46)}),
        sequence("thesis_zig_zag_jog", {jog(25), jog(16, -40.0), jog(23), jog(16, 40.0), jog(25)})}) {
    request.variation = 0.0;
    clips.add(request);
  }
  return clips.take();
}

}  // namespace stridegraph
