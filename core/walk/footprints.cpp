#include "walk/footprints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/floor_transform.h"

namespace stridegraph {
namespace {

/// Rounds in which footprints and corrections settle: millimetres become micrometres.
constexpr int kSettlingRounds = 30;

/// ContactMask has so many bits.
constexpr std::size_t kMostContacts = 8;

double largestHold(const FootTrack& track, std::size_t frame) {
  double largest = 0.0;
  for (const std::vector<double>& holds : track.holds) largest = std::max(largest, holds[frame]);
  return largest;
}

/// How much a second joint stands: then the foot lies flat and its yaw is that of the footprint.
double flatness(const FootTrack& track, std::size_t frame) {
  double largest = 0.0;
  double second = 0.0;
  for (const std::vector<double>& holds : track.holds) {
    second = std::max(second, std::min(largest, holds[frame]));
    largest = std::max(largest, holds[frame]);
  }
  return second;
}

/// A turn of the foot about the vertical, said twice.
struct FootTurn {
  Heading heading;
  double radians = 0.0;
};

/// Turns the flat foot to the mean heading of the stance; where it does not lie flat it is turned as in the
/// nearest frame before in which it does, or else after.
std::vector<FootTurn> turnCorrections(const FootTrack& track, const FootStance& stance) {
  Vec2 mean = Vec2::Zero();
  for (std::size_t f = stance.first; f <= stance.last; ++f)
    mean += flatness(track, f) * track.headings[f].direction();
  std::vector<FootTurn> turns(stance.last - stance.first + 1);
  if (mean.norm() == 0.0) return turns;
  const Heading wanted = Heading::alongDirection(mean);
  bool seen = false;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t frame = stance.first + i;
    if (flatness(track, frame) > 0.0) {
      const Heading turn = wanted - track.headings[frame];
      turns[i] = {turn, turn.angle().radians()};
      if (!seen) std::fill(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(i), turns[i]);
      seen = true;
    } else if (i > 0) {
      turns[i] = turns[i - 1];
    }
  }
  return turns;
}

/// Of one frame of a stance, the contact joints' places over the floor once the foot has been turned about
/// its ankle, and how much they hold.
struct TurnedFoot {
  std::array<Vec2, kMostContacts> places;
  std::array<double, kMostContacts> holds;
  double holdSum = 0.0;
};

std::vector<TurnedFoot> turnedFeet(const FootTrack& track, const FootStance& stance,
                                   const std::vector<FootTurn>& turns) {
  std::vector<TurnedFoot> feet(turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t frame = stance.first + i;
    const Vec2 ankle = onFloor(track.ankles[frame].position);
    for (std::size_t k = 0; k < track.points.size(); ++k) {
      feet[i].places[k] = ankle + turns[i].heading.rotate(onFloor(track.points[k][frame]) - ankle);
      feet[i].holds[k] = track.holds[k][frame];
      feet[i].holdSum += feet[i].holds[k];
    }
  }
  return feet;
}

/// Mean of points by how much they hold; zero when none does.
template <typename PointOf>
Vec2 meanByHold(const TurnedFoot& foot, std::size_t contacts, const PointOf& pointOf) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t k = 0; k < contacts; ++k) sum += foot.holds[k] * pointOf(k);
  return sum / foot.holdSum;
}

/// A place on the floor for each contact joint.
using Footprints = std::array<Vec2, kMostContacts>;

/// Footprints that settle: every frame is moved so that its standing joints come onto their prints in the
/// mean, and every print is the mean of where its joint then stands, by turns. One round takes print k to
/// begin[k] + the sum of share[k][l] times print l, so that rounds cost the same however long a stance is.
struct Settling {
  Footprints begin;
  std::array<std::array<double, kMostContacts>, kMostContacts> share{};

  Footprints after(const Footprints& prints, std::size_t contacts) const {
    Footprints settled = begin;
    for (std::size_t k = 0; k < contacts; ++k) {
      Vec2 sum = share[k][0] * prints[0];
      for (std::size_t l = 1; l < contacts; ++l) sum += share[k][l] * prints[l];
      settled[k] += sum;
    }
    return settled;
  }
};

Settling settlingOf(const std::vector<TurnedFoot>& feet, std::size_t contacts) {
  Settling settling;
  settling.begin.fill(Vec2::Zero());
  std::array<double, kMostContacts> sums{};
  for (const TurnedFoot& foot : feet) {
    const Vec2 middle = meanByHold(foot, contacts, [&](std::size_t k) { return foot.places[k]; });
    for (std::size_t k = 0; k < contacts; ++k) {
      sums[k] += foot.holds[k];
      settling.begin[k] += foot.holds[k] * (foot.places[k] - middle);
      for (std::size_t l = 0; l < contacts; ++l)
        settling.share[k][l] += foot.holds[k] * foot.holds[l] / foot.holdSum;
    }
  }
  for (std::size_t k = 0; k < contacts; ++k) {
    if (sums[k] == 0.0) continue;
    settling.begin[k] /= sums[k];
    for (std::size_t l = 0; l < contacts; ++l) settling.share[k][l] /= sums[k];
  }
  return settling;
}

/// The mean place of each joint while it stands, before anything is moved.
Footprints firstPrints(const std::vector<TurnedFoot>& feet, std::size_t contacts) {
  Footprints prints;
  prints.fill(Vec2::Zero());
  for (std::size_t k = 0; k < contacts; ++k) {
    Vec2 sum = Vec2::Zero();
    double weights = 0.0;
    for (const TurnedFoot& foot : feet) {
      sum += foot.holds[k] * foot.places[k];
      weights += foot.holds[k];
    }
    if (weights > 0.0) prints[k] = sum / weights;
  }
  return prints;
}

std::vector<Vec2> floorShifts(const FootTrack& track, const FootStance& stance,
                              const std::vector<FootTurn>& turns) {
  const std::size_t contacts = track.points.size();
  const std::vector<TurnedFoot> feet = turnedFeet(track, stance, turns);
  const Settling settling = settlingOf(feet, contacts);
  Footprints prints = firstPrints(feet, contacts);
  for (int round = 1; round < kSettlingRounds; ++round) prints = settling.after(prints, contacts);
  std::vector<Vec2> shifts;
  shifts.reserve(feet.size());
  for (const TurnedFoot& foot : feet)
    shifts.push_back(
        meanByHold(foot, contacts, [&](std::size_t k) { return Vec2(prints[k] - foot.places[k]); }));
  return shifts;
}

/// What exceeds `tolerance` >= 0, of either sign.
double beyond(double value, double tolerance) {
  return value - std::clamp(value, -tolerance, tolerance);
}

/// How far the foot goes up through a stance so that its joints stand at their levels, in the mean.
double liftOf(const FootTrack& track, const FootStance& stance, std::span<const double> levelsMetres) {
  const std::vector<double> heights = standingHeights(track, stance);
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::isnan(heights[k]) || std::isnan(levelsMetres[k])) continue;
    for (std::size_t f = stance.first; f <= stance.last; ++f) {
      sum += track.holds[k][f] * (levelsMetres[k] - heights[k]);
      weights += track.holds[k][f];
    }
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

PinnedStance pin(const FootTrack& track, const FootStance& stance, std::span<const double> levelsMetres,
                 const PinParams& params) {
  const std::vector<FootTurn> turns = turnCorrections(track, stance);
  const std::vector<Vec2> shifts = floorShifts(track, stance, turns);
  const double up = beyond(liftOf(track, stance, levelsMetres), params.sameLevelMetres);
  PinnedStance pinned{stance, {}};
  for (std::size_t i = 0; i < turns.size(); ++i)
    pinned.corrections.push_back({shifts[i].x(), up, shifts[i].y(), turns[i].radians, 0.0});
  return pinned;
}

bool isWithin(const PinnedStance& pinned, const PinParams& params) {
  return std::all_of(pinned.corrections.begin(), pinned.corrections.end(), [&](const FootCorrection& c) {
    return std::hypot(c[0], c[2]) <= params.farthestMetres && std::abs(c[3]) <= params.widestTurn.radians();
  });
}

bool isPulledAlong(const FootCorrection& before, const FootCorrection& after) {
  return (after - before).head<3>().norm() > kLargestPlaceSlope ||
         std::abs(after[3] - before[3]) > kLargestTurnSlope;
}

/// Without the frames at both ends in which the foot is pulled along.
PinnedStance trimmed(PinnedStance pinned) {
  std::vector<FootCorrection>& list = pinned.corrections;
  std::size_t end = list.size();
  while (end > 1 && isPulledAlong(list[end - 2], list[end - 1])) --end;
  std::size_t begin = 0;
  while (begin + 1 < end && isPulledAlong(list[begin], list[begin + 1])) ++begin;
  pinned.stance = {pinned.stance.first + begin, pinned.stance.first + end - 1};
  list = {list.begin() + static_cast<std::ptrdiff_t>(begin), list.begin() + static_cast<std::ptrdiff_t>(end)};
  return pinned;
}

void pinOrDivide(const FootTrack& track, const FootStance& stance, std::span<const double> levelsMetres,
                 const PinParams& params, std::vector<PinnedStance>& result) {
  if (stance.last - stance.first + 1 < params.leastFrames) return;
  PinnedStance pinned = pin(track, stance, levelsMetres, params);
  if (isWithin(pinned, params)) {
    pinned = trimmed(std::move(pinned));
    if (pinned.corrections.size() >= params.leastFrames) result.push_back(std::move(pinned));
    return;
  }
  std::size_t fastest = stance.first;
  for (std::size_t f = stance.first; f <= stance.last; ++f)
    if (largestHold(track, f) < largestHold(track, fastest)) fastest = f;
  // The foot needs time to get from the one place to the other.
  if (fastest > stance.first + params.leastFrames)
    pinOrDivide(track, {stance.first, fastest - params.leastFrames}, levelsMetres, params, result);
  if (fastest + params.leastFrames < stance.last)
    pinOrDivide(track, {fastest + params.leastFrames, stance.last}, levelsMetres, params, result);
}

}  // namespace

Quat yawTurn(double radians) {
  return Heading::fromAngle(Angle::radians(radians)).rotation();
}

std::vector<FootStance> findStances(const FootTrack& track, const PinParams& params) {
  std::vector<FootStance> stances;
  bool before = false;
  for (std::size_t f = 0; f < track.frameCount(); ++f) {
    const bool stands = largestHold(track, f) > 0.0;
    if (stands && !before) stances.push_back({f, f});
    if (stands) stances.back().last = f;
    before = stands;
  }
  std::erase_if(
      stances, [&](const FootStance& stance) { return stance.last - stance.first + 1 < params.leastFrames; });
  return stances;
}

std::vector<double> standingHeights(const FootTrack& track, const FootStance& stance) {
  std::vector<double> heights;
  for (std::size_t k = 0; k < track.points.size(); ++k) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t f = stance.first; f <= stance.last; ++f) {
      sum += track.holds[k][f] * track.points[k][f].y();
      weights += track.holds[k][f];
    }
    heights.push_back(weights > 0.0 ? sum / weights : std::numeric_limits<double>::quiet_NaN());
  }
  return heights;
}

std::vector<PinnedStance> pinStances(const FootTrack& track, std::span<const double> levelsMetres,
                                     const PinParams& params) {
  std::vector<PinnedStance> result;
  for (const FootStance& stance : findStances(track, params))
    pinOrDivide(track, stance, levelsMetres, params, result);
  return result;
}

}  // namespace stridegraph
