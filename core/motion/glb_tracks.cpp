#include "motion/glb_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stridegraph {
namespace {

using Key = std::array<float, 4>;

/// As a reader of the file finds it: of the numbers in single precision.
double dot(const Key& a, const Key& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  return sum;
}

}  // namespace

float finiteFloat(double value) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return std::isnan(value) ? 0.0F : static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

std::array<float, 4> rotationKey(const Quat& rotation) {
  const Eigen::Vector4d q = rotation.coeffs();
  const double length = q.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return {0.0F, 0.0F, 0.0F, 1.0F};
  Key key{};
  for (std::size_t i = 0; i < 4; ++i) key[i] = static_cast<float>(q[static_cast<Eigen::Index>(i)] / length);
  return key;
}

std::vector<float> keyTimes(const Clip& clip) {
  std::vector<float> times;
  times.reserve(clip.frameCount());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const float time = finiteFloat(static_cast<double>(f) / clip.framesPerSecond);
    // Hours into a clip of a very high rate, single precision no longer tells frames apart.
    const float least = f == 0 ? 0.0F : std::nextafter(times.back(), std::numeric_limits<float>::infinity());
    times.push_back(std::max(time, least));
  }
  return times;
}

std::vector<float> rootKeys(const Clip& clip, double liftMetres) {
  std::vector<float> keys;
  keys.reserve(3 * clip.frameCount());
  for (const Vec3& position : clip.rootPositions)
    for (const double coordinate : Vec3(position + liftMetres * Vec3::UnitY()))
      keys.push_back(finiteFloat(coordinate));
  return keys;
}

std::vector<float> rotationKeys(const Clip& clip, std::size_t joint) {
  std::vector<float> keys;
  keys.reserve(4 * clip.frameCount());
  Key before{};
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    Key key = rotationKey(clip.pose(f).rotations[joint]);
    if (dot(before, key) < 0.0)
      for (float& number : key) number = -number;
    keys.insert(keys.end(), key.begin(), key.end());
    before = key;
  }
  return keys;
}

}  // namespace stridegraph
