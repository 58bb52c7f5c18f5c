#include "motion/bvh_euler_track.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace stridegraph {
namespace {

using Degrees = std::array<double, 3>;
constexpr double kNegligibleDegrees = 1e-3;
/// Distance of the middle angle from a quarter turn at which the outer axes are taken to coincide: whatever
/// they turn against each other then changes the rotation by no more than kNegligibleDegrees.
constexpr double kLockedDegrees = 4e-4;

/// The value of angle + 360 n that is nearest to `reference`.
double unwrapped(double degrees, double reference) {
  return reference + std::remainder(degrees - reference, 360.0);
}

/// Both sets of angles of an order of three different axes: (a, b, c) and (a + 180, 180 - b, c + 180).
std::array<Degrees, 2> solutionsFor(const EulerOrder& order, const Quat& rotation, const Degrees& previous) {
  const std::array<Angle, 3> angles = toEuler(order, rotation);
  std::array<Degrees, 2> solutions = {
      {{angles[0].degrees(), angles[1].degrees(), angles[2].degrees()},
       {angles[0].degrees() + 180.0, 180.0 - angles[1].degrees(), angles[2].degrees() + 180.0}}};
  for (Degrees& solution : solutions) {
    for (std::size_t i = 0; i < 3; ++i) solution[i] = unwrapped(solution[i], previous[i]);
  }
  return solutions;
}

/// In gimbal lock the outer axes coincide and only the sum of their angles counts, or the difference: of all
/// pairs that give it the nearest to the frame before, from which both change alike.
void settleLock(const EulerOrder& order, const Degrees& previous, Degrees& solution) {
  const double fromLock = std::remainder(solution[1] - 90.0, 180.0);
  if (std::abs(fromLock) > kLockedDegrees) return;
  const bool isEven = (static_cast<int>(order[1]) - static_cast<int>(order[0]) + 3) % 3 == 1;
  const bool isUpper = std::sin(Angle::degrees(solution[1]).radians()) > 0.0;
  const double sense = isEven == isUpper ? 1.0 : -1.0;
  const double change = (solution[0] - previous[0]) + sense * (solution[2] - previous[2]);
  const double half = 0.5 * std::remainder(change, 360.0);
  solution[0] = previous[0] + half;
  solution[2] = previous[2] + sense * half;
}

/// How far the angles of the last axes are from zero: what a joint without channels for them cannot say.
double unsayable(const Degrees& solution, std::size_t axes) {
  double most = 0.0;
  for (std::size_t i = axes; i < 3; ++i) most = std::max(most, std::abs(std::remainder(solution[i], 360.0)));
  return most;
}

double distance(const Degrees& a, const Degrees& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// Angles frame by frame, as near to zero in the axes from `axes` on as can be, then as near to the frame
/// before as can be. `worst` is the farthest from zero that the axes from `axes` on come.
std::vector<Degrees> solve(const EulerOrder& order, const std::vector<Quat>& rotations, std::size_t axes,
                           double& worst) {
  std::vector<Degrees> track;
  track.reserve(rotations.size());
  Degrees previous = {0.0, 0.0, 0.0};
  worst = 0.0;
  for (const Quat& rotation : rotations) {
    auto [first, second] = solutionsFor(order, rotation, previous);
    if (axes == 3) {
      settleLock(order, previous, first);
      settleLock(order, previous, second);
    }
    const double firstRest = unsayable(first, axes);
    const double secondRest = unsayable(second, axes);
    const bool secondIsBetter = std::abs(firstRest - secondRest) > kNegligibleDegrees
                                    ? secondRest < firstRest
                                    : distance(second, previous) < distance(first, previous);
    previous = secondIsBetter ? second : first;
    worst = std::max(worst, std::min(firstRest, secondRest));
    track.push_back(previous);
  }
  return track;
}

}  // namespace

std::vector<Axis> withAllAxes(std::vector<Axis> axes) {
  for (const Axis axis : {Axis::kZ, Axis::kX, Axis::kY}) {
    if (std::find(axes.begin(), axes.end(), axis) == axes.end()) axes.push_back(axis);
  }
  return axes;
}

BvhEulerTrack bvhEulerTrack(std::vector<Axis> axes, const std::vector<Quat>& rotations) {
  STRIDEGRAPH_CHECK(axes.size() <= 3);
  std::vector<Axis> completed = withAllAxes(axes);
  const EulerOrder order = {completed[0], completed[1], completed[2]};
  double worst = 0.0;
  if (axes.size() < 3) {
    std::vector<Degrees> track = solve(order, rotations, axes.size(), worst);
    if (worst <= kNegligibleDegrees) return {std::move(axes), std::move(track)};
  }
  return {std::move(completed), solve(order, rotations, 3, worst)};
}

}  // namespace stridegraph
