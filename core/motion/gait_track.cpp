#include "motion/gait_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/gait_curves.h"
#include "motion/gait_step_noise.h"

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMarginSeconds = 1.5;
/// Below this speed the walk fades into standing (the slowest that the model was measured at, with a
/// reserve).
constexpr double kSlowestWalk = 0.75;
/// Share by which a tight turn is faster over the outer foot and slower over the inner one.
constexpr double kTurnEmphasis = 0.6;
/// Cadence and contact of small steps on the spot.
constexpr double kSteppingCadence = 6.6;
constexpr double kSteppingHalfWidth = 0.68 * kPi;
/// From step to step, one standard deviation: of cadence and of step length, as shares. People vary by 1 to 3
/// %; this much is seen, and clips still meet within 3 cm.
constexpr double kRhythmVariation = 0.010;
constexpr double kLengthVariation = 0.010;
constexpr double kMostStepsPerSecond = 6.0;

/// How much the turn rate alone makes the feet step.
double turningGate(const GaitMoment& moment) {
  return smoothStep(std::abs(moment.turnRate) / 0.6);
}

std::optional<Error> outOfRange(std::string_view what, double value, double low, double high) {
  if (value >= low && value <= high) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               fmt::format("{} is {} ({} to {} expected)", what, value, low, high)};
}

std::optional<Error> faultOf(const GaitSegment& segment, std::size_t index) {
  const auto name = [index](std::string_view what) { return fmt::format("{} of segment {}", what, index); };
  const bool jog = segment.gait == Gait::kJog;
  if (auto e = outOfRange(name("seconds"), segment.seconds, 1e-3, 60.0)) return e;
  if (auto e = outOfRange(name("speed"), segment.speed, jog ? 1.6 : 0.0, jog ? 3.4 : 2.3)) return e;
  return outOfRange(name("turnRate"), segment.turnRate, -2.5, 2.5);
}

std::optional<Error> faultOf(const GaitRequest& request) {
  if (request.segments.empty())
    return Error{ErrorCode::kInvalidArgument, "a gait request has no segments (at least one expected)"};
  for (std::size_t s = 0; s < request.segments.size(); ++s)
    if (auto e = faultOf(request.segments[s], s)) return e;
  if (auto e = outOfRange("framesPerSecond", request.framesPerSecond, 10.0, 240.0)) return e;
  if (auto e = outOfRange("speedBlendSeconds", request.speedBlendSeconds, 0.0, 2.0)) return e;
  if (auto e = outOfRange("turnBlendSeconds", request.turnBlendSeconds, 0.0, 2.0)) return e;
  if (auto e = outOfRange("variation", request.variation, 0.0, 2.0)) return e;
  return outOfRange("gaitBlendSeconds", request.gaitBlendSeconds, 0.0, 2.0);
}

/// Speed, turn rate and gait of every frame as asked, margins included.
GaitTrack askedTrack(const GaitRequest& request) {
  const double fps = request.framesPerSecond;
  GaitTrack track;
  track.margin = static_cast<std::size_t>(std::lround(kMarginSeconds * fps));
  for (std::size_t s = 0; s < request.segments.size(); ++s) {
    const GaitSegment& segment = request.segments[s];
    const double frames = std::max(1.0, std::round(segment.seconds * fps));
    GaitMoment moment;
    moment.speed = segment.speed;
    // Whole frames: the rate is adjusted so that the angle of the segment stays as asked.
    moment.turnRate = segment.turnRate * segment.seconds * fps / frames;
    moment.jogShare = segment.gait == Gait::kJog ? 1.0 : 0.0;
    std::size_t count = static_cast<std::size_t>(frames);
    if (s == 0) count += track.margin;
    if (s + 1 == request.segments.size()) count += track.margin;
    track.moments.insert(track.moments.end(), count, moment);
  }
  return track;
}

void smoothChannel(GaitTrack& track, double GaitMoment::*channel, double halfWidthFrames) {
  std::vector<double> values;
  for (const GaitMoment& moment : track.moments) values.push_back(moment.*channel);
  values = bellMean(values, static_cast<std::size_t>(std::lround(halfWidthFrames)));
  for (std::size_t i = 0; i < values.size(); ++i) track.moments[i].*channel = values[i];
}

double cadenceAt(const GaitMoment& moment) {
  const double speed = std::max(moment.speed, kSlowestWalk);
  const double going = std::lerp(gaitCadence(Gait::kWalk, speed, moment.turnRate),
                                 gaitCadence(Gait::kJog, speed, moment.turnRate), moment.jogShare);
  return std::lerp(kSteppingCadence * turningGate(moment), going, smoothStep(moment.speed / 0.15));
}

/// The phase by the trapezoidal rule, from zero at the first frame; steps are quicker and longer or slower
/// and shorter by what the noise says.
void integratePhase(GaitTrack& track, const GaitRequest& request) {
  const double fps = request.framesPerSecond;
  const double frames = static_cast<double>(track.moments.size());
  Random random(request.seed);
  const auto most = static_cast<std::size_t>(frames / fps * kMostStepsPerSecond) + 2;
  const StepNoise rhythm(random, most);
  const StepNoise length(random, most);
  for (std::size_t i = 1; i < track.moments.size(); ++i) {
    const GaitMoment& before = track.moments[i - 1];
    GaitMoment& now = track.moments[i];
    const double pace = 1.0 + request.variation * kRhythmVariation * rhythm.at(before.steps);
    now.phase = before.phase + pace * (cadenceAt(before) + cadenceAt(now)) * 0.5 / fps;
    now.steps = now.phase / kPi;
  }
  for (GaitMoment& moment : track.moments)
    moment.speed *= 1.0 + request.variation * (kRhythmVariation * rhythm.at(moment.steps) +
                                               kLengthVariation * length.at(moment.steps));
}

/// How much more of the turn falls to this moment than on average: people turn while the outer foot carries,
/// so that their feet need not cross.
double turnEmphasis(const GaitMoment& moment) {
  const double tight = smoothStep((std::abs(moment.turnRate) - 0.7) / 0.8);
  const double depth = kTurnEmphasis * tight * walkingShare(moment) * (1.0 - moment.jogShare);
  const double outerFoot = -std::cos(moment.phase - contactAt(moment).middle());
  return 1.0 + depth * std::copysign(1.0, moment.turnRate) * outerFoot;
}

/// Gives more of each turn to the frames in which the outer foot carries; its whole angle stays.
void emphasiseOuterFoot(GaitTrack& track) {
  auto& moments = track.moments;
  std::size_t first = 0;
  while (first < moments.size()) {
    const double side = std::copysign(1.0, moments[first].turnRate);
    std::size_t next = first;
    double plain = 0.0;
    double stressed = 0.0;
    for (; next < moments.size() && moments[next].turnRate * side >= 0.0; ++next) {
      plain += moments[next].turnRate;
      stressed += moments[next].turnRate * turnEmphasis(moments[next]);
    }
    const double scale = stressed * side > 0.0 ? plain / stressed : 1.0;
    for (std::size_t i = first; i < next; ++i) moments[i].turnRate *= scale * turnEmphasis(moments[i]);
    first = std::max(next, first + 1);
  }
}

/// Integrates heading and place by the trapezoidal rule; both are zero at the first frame of the clip.
void integratePath(GaitTrack& track, double fps) {
  auto& moments = track.moments;
  const auto slip = [](const GaitMoment& m) {
    const Angle walk = gaitSlip(Gait::kWalk, m.turnRate, m.turnAcceleration);
    const Angle jog = gaitSlip(Gait::kJog, m.turnRate, m.turnAcceleration);
    return walk * (1.0 - m.jogShare) + jog * m.jogShare;
  };
  for (std::size_t i = 1; i + 1 < moments.size(); ++i)
    moments[i].turnAcceleration = (moments[i + 1].turnRate - moments[i - 1].turnRate) * 0.5 * fps;
  Vec2 velocityBefore = Vec2::Zero();
  for (std::size_t i = 0; i < moments.size(); ++i) {
    GaitMoment& now = moments[i];
    if (i > 0) {
      const GaitMoment& before = moments[i - 1];
      now.heading = before.heading + Angle::radians((before.turnRate + now.turnRate) * 0.5 / fps);
    }
    const Vec2 velocity = now.speed * Heading::fromAngle(now.heading + slip(now)).direction();
    if (i > 0) now.place = moments[i - 1].place + (velocityBefore + velocity) * (0.5 / fps);
    velocityBefore = velocity;
  }
  const FloorTransform first{moments[track.margin].place, Heading::fromAngle(moments[track.margin].heading)};
  const FloorTransform back = first.inverse();
  const Angle turned = moments[track.margin].heading;
  for (GaitMoment& moment : moments) {
    moment.place = back * moment.place;
    moment.heading = moment.heading - turned;
  }
}

/// Shifts and stretches the phase to what the request asks for at its ends.
void settlePhase(GaitTrack& track, const GaitRequest& request) {
  auto& moments = track.moments;
  const double first = moments[track.margin].phase;
  const double last = moments[moments.size() - 1 - track.margin].phase;
  double scale = 1.0;
  double start = request.startPhase.value_or(0.0);
  if (request.endPhase && !request.startPhase) start = *request.endPhase - (last - first);
  if (request.endPhase && request.startPhase && last > first) {
    const double cycles = std::round((last - first - (*request.endPhase - start)) / (2.0 * kPi));
    scale = (*request.endPhase - start + 2.0 * kPi * cycles) / (last - first);
  }
  for (GaitMoment& moment : moments) moment.phase = start + scale * (moment.phase - first);
}

}  // namespace

double walkingShare(const GaitMoment& moment) {
  return smoothStep(moment.speed / kSlowestWalk);
}

double steppingShare(const GaitMoment& moment) {
  return turningGate(moment) * (1.0 - walkingShare(moment));
}

ContactPhases contactAt(const GaitMoment& moment) {
  const double speed = std::max(moment.speed, kSlowestWalk);
  const ContactPhases walk = gaitContact(Gait::kWalk, speed);
  const ContactPhases jog = gaitContact(Gait::kJog, speed);
  const double middle = std::lerp(walk.middle(), jog.middle(), moment.jogShare);
  const double going = std::lerp(walk.halfWidth(), jog.halfWidth(), moment.jogShare);
  const double still = std::lerp(kPi, kSteppingHalfWidth, turningGate(moment));
  const double halfWidth = std::lerp(still, going, smoothStep(moment.speed / 0.35));
  return {middle - halfWidth, middle + halfWidth};
}

Result<GaitTrack> layTrack(const GaitRequest& request) {
  if (auto error = faultOf(request)) return tl::unexpected<Error>(std::move(*error));
  const double fps = request.framesPerSecond;
  GaitTrack track = askedTrack(request);
  smoothChannel(track, &GaitMoment::speed, request.speedBlendSeconds * fps);
  smoothChannel(track, &GaitMoment::turnRate, request.turnBlendSeconds * fps);
  smoothChannel(track, &GaitMoment::jogShare, request.gaitBlendSeconds * fps);
  integratePhase(track, request);
  settlePhase(track, request);
  emphasiseOuterFoot(track);
  integratePath(track, fps);
  return track;
}

}  // namespace stridegraph
