#include "motion/gait_flight.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "base/check.h"
#include "motion/gait_footprint.h"

namespace stridegraph {
namespace {

constexpr double kGravity = 9.81;     ///< m/s^2
constexpr double kBounceGain = 1.10;  ///< Captured bounce by that of the mean over strides.
constexpr double kCrouch = 0.014;     ///< Lower than that mean, so that knees do not lock at landing, metres.
constexpr double kFlightWeight = 40.0;  ///< Of an acceleration error in flight against one in stance.
constexpr double kChangeWeight = 0.12;  ///< Of a change of height, in units of an acceleration per frame.

/// Whether no foot is down while jogging. In the last frame of a stance the toes have left the floor.
std::vector<bool> flights(const GaitTrack& track) {
  std::vector<bool> flying;
  for (const GaitMoment& moment : track.moments) flying.push_back(moment.jogShare > 0.5);
  for (const Side side : {Side::kLeft, Side::kRight})
    for (const Stance& stance : stancesOf(track, side))
      for (std::size_t f = stance.first; f < stance.last; ++f) flying[f] = false;
  return flying;
}

/// Mean over a stride of the heights round each frame.
std::vector<double> meanHeights(const std::vector<double>& heights, std::ptrdiff_t reach) {
  const auto last = static_cast<std::ptrdiff_t>(heights.size()) - 1;
  std::vector<double> means;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    double sum = 0.0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k)
      sum += heights[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + k, 0, last))];
    means.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  return means;
}

}  // namespace

void fallFreely(const GaitTrack& track, Clip& clip) {
  STRIDEGRAPH_CHECK(track.moments.size() == clip.frameCount());
  const std::vector<bool> flying = flights(track);
  const std::size_t count = clip.frameCount();
  if (std::none_of(flying.begin(), flying.end(), [](bool is) { return is; }) || count < 3) return;
  std::vector<double> heights;
  for (const Vec3& root : clip.rootPositions) heights.push_back(root.y());
  const double fps = clip.framesPerSecond;
  const std::vector<double> means = meanHeights(heights, std::lround(0.36 * fps));
  const double fall = -kGravity / (fps * fps);

  // Normal equations of the heights h: in flight h'' = -g, elsewhere h'' as it was; h near its amplified
  // self, and all but fixed where there is no jog.
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (std::size_t f = 0; f < count; ++f) {
    const double jog = track.moments[f].jogShare;
    const auto i = static_cast<Eigen::Index>(f);
    const double weight = kChangeWeight * kChangeWeight + 100.0 * (1.0 - jog);
    normal(i, i) += weight;
    const double bounced = (kBounceGain - 1.0) * (heights[f] - means[f]) - kCrouch;
    right(i) += weight * (heights[f] + jog * bounced);
    if (f == 0 || f + 1 == count) continue;
    const double wanted = flying[f] ? fall : heights[f - 1] - 2.0 * heights[f] + heights[f + 1];
    const double share = flying[f] ? kFlightWeight : 1.0;
    const Eigen::Vector3d row(1.0, -2.0, 1.0);
    normal.block<3, 3>(i - 1, i - 1) += share * row * row.transpose();
    right.segment<3>(i - 1) += share * wanted * row;
  }
  const Eigen::VectorXd solved = normal.ldlt().solve(right);
  for (std::size_t f = 0; f < count; ++f) clip.rootPositions[f].y() = solved(static_cast<Eigen::Index>(f));
}

}  // namespace stridegraph
