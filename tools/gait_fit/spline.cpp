#include "gait_fit/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stridegraph::gait_fit {

using Eigen::Index;

Spline cubicSpline(Index frames, double knotFrames, double framesPerSecond) {
  const auto pieces =
      std::max<Index>(1, static_cast<Index>(std::ceil(static_cast<double>(frames - 1) / knotFrames)));
  const double piecesPerFrame = static_cast<double>(pieces) / static_cast<double>(frames - 1);
  const double perSecond = piecesPerFrame * framesPerSecond;
  Spline spline;
  spline.values = Eigen::MatrixXd::Zero(frames, pieces + 3);
  spline.slopes = spline.values;
  for (Index f = 0; f < frames; ++f) {
    const double at = static_cast<double>(f) * piecesPerFrame;
    const Index piece = std::min<Index>(static_cast<Index>(at), pieces - 1);
    const double t = at - static_cast<double>(piece);
    const double s = 1.0 - t;
    const std::array value = {s * s * s / 6.0, (3 * t * t * t - 6 * t * t + 4) / 6.0,
                              (3 * s * s * s - 6 * s * s + 4) / 6.0, t * t * t / 6.0};
    const std::array slope = {-s * s / 2.0, (9 * t * t - 12 * t) / 6.0, (12 * s - 9 * s * s) / 6.0,
                              t * t / 2.0};
    for (std::size_t k = 0; k < value.size(); ++k) {
      spline.values(f, piece + static_cast<Index>(k)) = value[k];
      spline.slopes(f, piece + static_cast<Index>(k)) = slope[k] * perSecond;
    }
  }
  spline.thirdDifferences = Eigen::MatrixXd::Zero(pieces, pieces + 3);
  for (Index i = 0; i < pieces; ++i) spline.thirdDifferences.block<1, 4>(i, i) << -1, 3, -3, 1;
  return spline;
}

Eigen::VectorXd smoothed(const Eigen::VectorXd& values, Index reach) {
  Eigen::VectorXd result(values.size());
  for (Index f = 0; f < values.size(); ++f) {
    double sum = 0.0;
    double weights = 0.0;
    for (Index k = -reach; k <= reach; ++k) {
      const double weight =
          1.0 + std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(reach + 1));
      sum += weight * values[std::clamp<Index>(f + k, 0, values.size() - 1)];
      weights += weight;
    }
    result[f] = sum / weights;
  }
  return result;
}

Eigen::VectorXd slopeOf(const Eigen::VectorXd& values, double framesPerSecond) {
  Eigen::VectorXd slopes(values.size());
  for (Index f = 0; f < values.size(); ++f) {
    const Index before = std::max<Index>(f - 1, 0);
    const Index after = std::min<Index>(f + 1, values.size() - 1);
    slopes[f] = (values[after] - values[before]) * framesPerSecond / static_cast<double>(after - before);
  }
  return slopes;
}

Eigen::VectorXd unwrapped(const Eigen::VectorXd& angles) {
  Eigen::VectorXd result = angles;
  for (Index f = 1; f < angles.size(); ++f)
    result[f] = result[f - 1] + std::remainder(angles[f] - angles[f - 1], 2.0 * std::numbers::pi);
  return result;
}

}  // namespace stridegraph::gait_fit
