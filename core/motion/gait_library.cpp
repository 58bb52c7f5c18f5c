#include "motion/gait_library.h"

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
  void add(const GaitRequest& request) {
    Result<Clip> clip = synthesiseGait(request);
    STRIDEGRAPH_CHECK(clip.has_value());
    clips_.push_back(std::move(*clip));
  }

  /// "name_left" as asked and "name_right" mirrored.
  void addBothHands(GaitRequest request) {
    const std::string name = request.name;
    request.name = name + "_left";
    add(request);
    request.name = name + "_right";
    for (GaitSegment& segment : request.segments) segment.turnRate = -segment.turnRate;
    if (!request.startPhase && !request.endPhase) request.startPhase = 0.0;
    if (request.startPhase) *request.startPhase += kPi;
    if (request.endPhase) *request.endPhase += kPi;
    add(request);
  }

  std::vector<Clip> take() { return std::move(clips_); }

 private:
  std::vector<Clip> clips_;
};

/// The foot that carries in the middle of a turn.
enum class Carrier { kOuter, kInner };

/// Lets the right foot (outer in a left turn) or the left one carry in the middle of the request.
void carryInTheMiddle(Carrier carrier, GaitRequest& request) {
  request.startPhase = 0.0;
  const Result<GaitTrack> track = layTrack(request);
  STRIDEGRAPH_CHECK(track.has_value());
  const GaitMoment& middle = track->moments[track->moments.size() / 2];
  const double leftCarries = contactAt(middle).middle();
  request.startPhase = leftCarries + (carrier == Carrier::kOuter ? kPi : 0.0) - middle.phase;
}

/// Straight, a turn to the left, straight. The radius is the speed in the turn by its rate.
GaitRequest turn(std::string name, double degrees, const Turning& how, Carrier carrier) {
  const double seconds = degrees * kPi / 180.0 / how.turnRate;
  const GaitSegment straight{kLeadSeconds, how.straightSpeed, 0.0, how.gait};
  GaitRequest request;
  request.name = std::move(name);
  request.segments = {straight, {seconds, how.turnSpeed, how.turnRate, how.gait}, straight};
  request.speedBlendSeconds = 0.35;
  carryInTheMiddle(carrier, request);
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
  clips.add(sequence("walk_1.3", {{3.0, 1.3}}));
  clips.add(sequence("walk_1.5", {{2.5, 1.5}}));
  clips.add(sequence("walk_1.7", {{2.5, 1.7}}));
  clips.add(sequence("walk_speeds",
                     {{1.2, 0.8}, {1.2, 1.0}, {1.2, 1.3}, {1.2, 1.7}, {1.2, 1.3}, {1.2, 1.0}, {1.2, 0.8}}));
}

void addTurns(Collector& clips) {
  const Turning tight{1.0, 0.75, 1.7};
  clips.addBothHands(turn("walk_tight_45", 45, tight, Carrier::kOuter));
  clips.addBothHands(turn("walk_tight_90", 90, tight, Carrier::kOuter));
  clips.addBothHands(turn("walk_tight_90_other_foot", 90, {1.0, 0.75, 1.3}, Carrier::kInner));
  clips.addBothHands(turn("walk_tight_135", 135, tight, Carrier::kOuter));
  clips.addBothHands(turn("walk_tight_180", 180, tight, Carrier::kInner));
  clips.addBothHands(turn("walk_sharp_90", 90, {1.0, 0.65, 2.2}, Carrier::kOuter));
  const Turning wide{1.3, 1.25, 1.1};
  clips.addBothHands(turn("walk_wide_45", 45, wide, Carrier::kOuter));
  clips.addBothHands(turn("walk_wide_90", 90, wide, Carrier::kInner));
  clips.addBothHands(turn("walk_wide_135", 135, wide, Carrier::kOuter));
  clips.addBothHands(turn("walk_wide_180", 180, wide, Carrier::kInner));
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
  GaitRequest start = sequence("start", {{1.3, 0.0}, {1.8, 1.0}});
  start.startPhase = kLeftCarries;
  clips.addBothHands(start);
  GaitRequest stop = sequence("stop", {{1.7, 1.0}, {1.5, 0.0}});
  stop.endPhase = kRightCarries;
  clips.addBothHands(stop);
  for (const double degrees : {90.0, 180.0}) {
    GaitRequest spot = turn("turn_on_the_spot_" + std::to_string(std::lround(degrees)), degrees,
                            {0.0, 0.0, 1.25}, Carrier::kOuter);
    spot.startPhase = kLeftCarries;
    clips.addBothHands(spot);
  }
}

void addJogs(Collector& clips) {
  clips.add(sequence("jog_2.4", {{2.4, 2.4, 0.0, Gait::kJog}}));
  clips.add(sequence("jog_2.8", {{2.4, 2.8, 0.0, Gait::kJog}}));
  clips.addBothHands(turn("jog_veer", 60, {2.6, 2.6, 1.0, Gait::kJog}, Carrier::kOuter));
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

}  // namespace stridegraph
