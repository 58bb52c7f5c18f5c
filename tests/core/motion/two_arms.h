#pragma once

#include <vector>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/clip.h"

namespace stridegraph::testing {

/// A trunk with two bent arms and a nose, symmetric about x = 0. Both shoulders hang on joints of no length.
inline Skeleton twoArms() {
  const auto at = [](std::size_t index) { return JointIndex(index); };
  Skeleton skeleton;
  skeleton.joints = {{"hips", {}, {0, 0, 0}},
                     {"chest", at(0), {0, 0.5, 0.02}},
                     {"lshoulder", at(1), {0, 0, 0}},
                     {"lelbow", at(2), {0.3, 0.1, 0.05}},
                     {"lelbow#end", at(3), {0.25, -0.1, 0.1}, true},
                     {"rshoulder", at(1), {0, 0, 0}},
                     {"relbow", at(5), {-0.3, 0.1, 0.05}},
                     {"relbow#end", at(6), {-0.25, -0.1, 0.1}, true},
                     {"chest#end", at(1), {0, 0.3, 0.1}, true}};
  return skeleton;
}

/// Which joint of twoArms() is on the other side of each.
inline const std::vector<std::size_t> kTwoArmsPartners = {0, 1, 5, 6, 7, 2, 3, 4, 8};

/// Frames in which every joint turns smoothly about an axis of its own, by up to 60 degrees.
inline Clip waving(const Skeleton& skeleton, std::size_t frames, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> axes;
  std::vector<double> phases;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    axes.push_back(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized());
    phases.push_back(random.uniform(0.0, 6.0));
  }
  Clip clip;
  clip.name = "waving";
  clip.jointCount = skeleton.size();
  for (std::size_t f = 0; f < frames; ++f) {
    const auto t = static_cast<double>(f);
    Pose pose{{0.1 * t, 1.0, 0.03 * t}, {}};
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      const double angle = skeleton.joints[j].isEndSite ? 0.0 : std::sin(phases[j] + 0.1 * t);
      pose.rotations.emplace_back(Eigen::AngleAxisd(angle, axes[j]));
    }
    clip.append(pose.view());
  }
  return clip;
}

}  // namespace stridegraph::testing
