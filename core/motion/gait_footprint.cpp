#include "motion/gait_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/rotation.h"
#include "motion/gait_toes.h"

namespace stridegraph {
namespace {

/// Heights of heel and toe end within which the weight goes from one to the other.
constexpr double kRollMetres = 0.004;
/// Fastest change of a correction where a swing begins or ends, per frame.
constexpr double kLargestPlaceSlope = 0.012;
constexpr double kLargestAngleSlope = 0.05;
/// Share of the weight on the heel from which on it is not lifted.
constexpr double kHeelDown = 0.9;
/// Part of a swing in which the lifted heel comes back to where the model has it.
constexpr double kPitchShare = 0.45;
/// Most that the heel is lifted over what the model does, rad.
constexpr double kLargestHeelLift = 0.26;

double wrappedDifference(Angle a, Angle b) {
  return (a - b).wrapped().radians();
}

bool standsStill(const GaitMoment& moment) {
  return moment.speed < 0.01 && std::abs(moment.turnRate) < 0.01;
}

/// Horizontal distance from heel to toe end in the flat foot.
double flatLength(const FootMotion& foot) {
  return (foot.ballInFoot + foot.toeFromBall - foot.heelInFoot).norm();
}

double hermite(double from, double fromSlope, double to, double toSlope, double share) {
  const double s2 = share * share;
  const double s3 = s2 * share;
  return from * (2 * s3 - 3 * s2 + 1) + fromSlope * (s3 - 2 * s2 + share) + to * (3 * s2 - 2 * s3) +
         toSlope * (s3 - s2);
}

Vec3 limited(const Vec3& slope) {
  const double length = slope.norm();
  return length > kLargestPlaceSlope ? Vec3(slope * (kLargestPlaceSlope / length)) : slope;
}

/// Change of the correction from one frame to the next, both fixed; zero otherwise.
FootCorrection slopeBetween(const std::vector<bool>& fixed, const std::vector<FootCorrection>& corrections,
                            std::size_t frame, std::size_t next) {
  if (next >= fixed.size() || frame >= fixed.size() || !fixed[frame] || !fixed[next]) return {};
  const auto limitedAngle = [](double slope) {
    return std::clamp(slope, -kLargestAngleSlope, kLargestAngleSlope);
  };
  const FootCorrection& from = corrections[frame];
  const FootCorrection& to = corrections[next];
  return {limited(to.place - from.place), limitedAngle(to.yaw - from.yaw),
          limitedAngle(to.pitch - from.pitch), limitedAngle(to.toeBend - from.toeBend)};
}

FootCorrection between(const std::array<FootCorrection, 2>& ends, const std::array<FootCorrection, 2>& slopes,
                       double span, double share) {
  FootCorrection result;
  for (int a = 0; a < 3; ++a)
    result.place[a] = hermite(ends[0].place[a], slopes[0].place[a] * span, ends[1].place[a],
                              slopes[1].place[a] * span, share);
  result.yaw = hermite(ends[0].yaw, slopes[0].yaw * span, ends[1].yaw, slopes[1].yaw * span, share);
  // The heel that was lifted for want of reach comes down soon; what the next stance needs begins late.
  const double early = std::min(1.0, share / kPitchShare);
  const double late = std::max(0.0, (share - 1.0) / kPitchShare + 1.0);
  result.pitch = hermite(ends[0].pitch, slopes[0].pitch * span * kPitchShare, 0.0, 0.0, early) +
                 hermite(0.0, 0.0, ends[1].pitch, slopes[1].pitch * span * kPitchShare, late);
  result.toeBend = hermite(ends[0].toeBend, 0.0, 0.0, 0.0, early);
  return result;
}

/// Corrections of the frames first..next-1 of a swing.
void fillSwing(const std::vector<bool>& fixed, std::size_t first, std::size_t next,
               std::vector<FootCorrection>& corrections) {
  const bool hasBefore = first > 0;
  const bool hasAfter = next < fixed.size();
  if (!hasBefore && !hasAfter) return;
  if (!hasBefore || !hasAfter) {
    for (std::size_t f = first; f < next; ++f) corrections[f] = corrections[hasBefore ? first - 1 : next];
    return;
  }
  const std::array<FootCorrection, 2> ends = {corrections[first - 1], corrections[next]};
  const std::array<FootCorrection, 2> slopes = {
      first > 1 ? slopeBetween(fixed, corrections, first - 2, first - 1) : FootCorrection{},
      slopeBetween(fixed, corrections, next, next + 1)};
  const double span = static_cast<double>(next - first + 1);
  for (std::size_t f = first; f < next; ++f)
    corrections[f] = between(ends, slopes, span, static_cast<double>(f - first + 1) / span);
}

}  // namespace

Angle FootMotion::yaw() const {
  const Vec3 sideways = rotation * Vec3::UnitX();
  return Angle::radians(std::atan2(-sideways.z(), sideways.x()));
}

Vec3 FootMotion::toeInFoot() const {
  return ballInFoot + axisRotation(Axis::kX, Angle::radians(-toeBend)) * toeFromBall;
}

double FootMotion::heelShare() const {
  return 1.0 / (1.0 + std::exp((heel().y() - toe().y()) / kRollMetres));
}

std::vector<Stance> stancesOf(const GaitTrack& track, Side side) {
  std::vector<Stance> stances;
  bool before = false;
  for (std::size_t i = 0; i < track.moments.size(); ++i) {
    const GaitMoment& moment = track.moments[i];
    const ContactPhases contact = contactAt(moment);
    const double phase = moment.phase + (side == Side::kLeft ? 0.0 : std::numbers::pi);
    const double off = std::abs(std::remainder(phase - contact.middle(), 2.0 * std::numbers::pi));
    const bool down = off <= contact.halfWidth();
    if (down && !before) stances.push_back({i, i});
    if (down) stances.back().last = i;
    before = down;
  }
  return stances;
}

Footprint footprintOf(const std::vector<FootMotion>& foot, const GaitTrack& track, const Stance& stance) {
  Vec2 place = Vec2::Zero();
  Vec2 direction = Vec2::Zero();
  double weights = 0.0;
  const double length = static_cast<double>(std::max<std::size_t>(stance.last - stance.first, 1));
  for (std::size_t i = stance.first; i <= stance.last; ++i) {
    const FootMotion& now = foot[i];
    const double share = static_cast<double>(i - stance.first) / length;
    const double bell = std::exp(-0.5 * std::pow((share - 0.45) / 0.12, 2.0));
    const double weight = standsStill(track.moments[i]) ? 1.0 : 1e-6 * bell;
    const Vec2 forward = Heading::fromAngle(now.yaw()).direction();
    const double onHeel = now.heelShare();
    place += weight * (onHeel * onFloor(now.heel()) +
                       (1.0 - onHeel) * (onFloor(now.toe()) - flatLength(now) * forward));
    direction += weight * forward;
    weights += weight;
  }
  return {place / weights, Heading::alongDirection(direction).angle()};
}

FootCorrection correctionTo(const Footprint& print, const FootMotion& foot) {
  FootCorrection correction;
  correction.yaw = wrappedDifference(print.yaw, foot.yaw());
  const Quat rotation = Heading::fromAngle(Angle::radians(correction.yaw)).rotation() * foot.rotation;
  const Vec2 toe = print.heel + flatLength(foot) * Heading::fromAngle(print.yaw).direction();
  const double onHeel = foot.heelShare();
  const Vec3 overHeel = Vec3(print.heel.x(), kGaitSoleMetres, print.heel.y()) - rotation * foot.heelInFoot;
  const Vec3 overToe = Vec3(toe.x(), kGaitSoleMetres, toe.y()) - rotation * foot.toeInFoot();
  correction.place = onHeel * overHeel + (1.0 - onHeel) * overToe - foot.ankle;
  // Between the two the mean of both would press the lower one into the floor.
  const FootMotion placed = corrected(foot, correction);
  correction.place.y() += kGaitSoleMetres - std::min(placed.heel().y(), placed.toe().y());
  return correction;
}

void liftHeel(const FootMotion& foot, const Vec3& hip, double reachMetres, FootCorrection& correction) {
  const FootMotion flat = corrected(foot, correction);
  // A flat foot rests on heel and toes at once: it must not depend on which of them is a hair lower.
  const double onToes = std::clamp((kHeelDown - foot.heelShare()) / (kHeelDown - 0.5), 0.0, 1.0);
  if ((flat.ankle - hip).norm() <= reachMetres || onToes <= 0.0) return;
  const Vec3 toe = flat.toe();
  const double pitched = pitchBeyondFlat(flat);
  const auto bendAt = [&](double pitch) { return toeBend(pitched + pitch) - toeBend(pitched); };
  const auto ankleAt = [&](double pitch) {
    FootMotion lifted = flat;
    lifted.toeBend += bendAt(pitch);
    return Vec3(toe - flat.rotation * axisRotation(Axis::kX, Angle::radians(pitch)) * lifted.toeInFoot());
  };
  double low = 0.0;
  double high = kLargestHeelLift;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    ((ankleAt(middle) - hip).norm() <= reachMetres ? high : low) = middle;
  }
  const double lift = onToes * high;
  correction.pitch += lift;
  correction.toeBend += bendAt(lift);
  correction.place = ankleAt(lift) - foot.ankle;
}

FootMotion corrected(const FootMotion& foot, const FootCorrection& correction) {
  FootMotion result = foot;
  result.ankle += correction.place;
  result.toeBend += correction.toeBend;
  result.rotation = (Heading::fromAngle(Angle::radians(correction.yaw)).rotation() * foot.rotation *
                     axisRotation(Axis::kX, Angle::radians(correction.pitch)))
                        .normalized();
  return result;
}

void carryThroughSwing(const std::vector<bool>& fixed, std::vector<FootCorrection>& corrections) {
  const std::size_t count = fixed.size();
  std::size_t first = 0;
  while (first < count) {
    std::size_t next = first + 1;
    while (next < count && fixed[next] == fixed[first]) ++next;
    if (!fixed[first]) fillSwing(fixed, first, next, corrections);
    first = next;
  }
}

}  // namespace stridegraph
