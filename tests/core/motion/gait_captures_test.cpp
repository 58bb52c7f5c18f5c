#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/bvh_reader.h"
#include "motion/captures.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"

namespace stridegraph {
namespace {

/// How fast each joint turns and how hard it accelerates, frame by frame; the root is left out.
struct Rates {
  std::vector<std::vector<double>> speeds;         ///< rad/s, for each joint
  std::vector<std::vector<double>> accelerations;  ///< rad/s^2, for each joint
};

Vec3 turnBetween(const Quat& from, const Quat& to) {
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  return turn.axis() * Angle::radians(turn.angle()).wrapped().radians();
}

void addRates(const Clip& clip, Rates& rates) {
  rates.speeds.resize(clip.jointCount);
  rates.accelerations.resize(clip.jointCount);
  const double fps = clip.framesPerSecond;
  for (std::size_t j = 1; j < clip.jointCount; ++j) {
    Vec3 before = Vec3::Zero();
    for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
      const Vec3 now = turnBetween(clip.pose(f).rotations[j], clip.pose(f + 1).rotations[j]) * fps;
      rates.speeds[j].push_back(now.norm());
      if (f > 0) rates.accelerations[j].push_back((now - before).norm() * fps);
      before = now;
    }
  }
}

/// What is exceeded by one value in a thousand only, so that no single glitch of a capture counts.
double almostLargest(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(0.999 * static_cast<double>(values.size() - 1))];
}

/// Toes are rigid in the captures: nothing to compare with. End sites do not turn.
bool isCompared(std::size_t joint) {
  const std::string& name = gaitSkeleton().joints[joint].name;
  return joint > 0 && name.find("toes") == std::string::npos && !gaitSkeleton().joints[joint].isEndSite;
}

double rootMeanSquare(const Rates& rates) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t j = 1; j < rates.accelerations.size(); ++j) {
    if (!isCompared(j)) continue;
    for (const double value : rates.accelerations[j]) sum += value * value;
    count += rates.accelerations[j].size();
  }
  return std::sqrt(sum / static_cast<double>(count));
}

/// Rates of the captures in a folder whose names hold one of the words.
Rates ratesOfCaptures(std::string_view folder, std::initializer_list<const char*> words) {
  Rates rates;
  for (const auto& file : testing::captures(folder)) {
    const std::string name = file.stem().string();
    const auto isIn = [&name](const char* word) { return name.find(word) != std::string::npos; };
    if (std::none_of(words.begin(), words.end(), isIn)) continue;
    const auto document = readBvh(testing::contentOf(file), name);
    if (document) addRates(document->clip, rates);
  }
  return rates;
}

const Clip& named(const std::vector<Clip>& clips, const std::string& name) {
  const auto found =
      std::find_if(clips.begin(), clips.end(), [&name](const Clip& clip) { return clip.name == name; });
  EXPECT_NE(found, clips.end()) << name;
  return found == clips.end() ? clips.front() : *found;
}

TEST(DefaultGaitClips, moveNoJointHarderThanCaptures) {
  if (testing::captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  const Rates captured = ratesOfCaptures("", {"16_"});
  for (const Clip& clip : defaultGaitClips()) {
    Rates own;
    addRates(clip, own);
    for (std::size_t j = 1; j < clip.jointCount; ++j) {
      if (!isCompared(j)) continue;
      // Joints that are still in the captures may move as slowly as the referee ignores.
      const double speed = std::max(almostLargest(captured.speeds[j]), 0.5);
      const double acceleration = std::max(almostLargest(captured.accelerations[j]), 15.0);
      const std::string& joint = gaitSkeleton().joints[j].name;
      EXPECT_LT(*std::max_element(own.speeds[j].begin(), own.speeds[j].end()), 1.05 * speed)
          << clip.name << " " << joint;
      EXPECT_LT(*std::max_element(own.accelerations[j].begin(), own.accelerations[j].end()),
                1.05 * acceleration)
          << clip.name << " " << joint;
    }
  }
}

TEST(DefaultGaitClips, areAsLivelyAsCapturesOfTheirSpeed) {
  if (testing::captures().empty()) GTEST_SKIP() << testing::kNoCaptures;
  const std::vector<Clip> clips = defaultGaitClips();
  const auto liveliness = [&clips](const char* name, const Rates& captured) {
    Rates own;
    addRates(named(clips, name), own);
    return rootMeanSquare(own) / rootMeanSquare(captured);
  };
  for (const auto& [name, captured] :
       {std::pair{"walk_1.0", ratesOfCaptures("cmu16_walk", {"16_31", "16_32"})},
        {"walk_1.3", ratesOfCaptures("cmu16_walk", {"16_47", "16_58"})},
        {"walk_1.7", ratesOfCaptures("cmu16_walk", {"16_21", "16_22"})},
        {"jog_2.8", ratesOfCaptures("cmu16_jog", {"16_35", "16_36"})}}) {
    EXPECT_GT(liveliness(name, captured), 0.8) << name;
    EXPECT_LT(liveliness(name, captured), 1.1) << name;
  }
}

}  // namespace
}  // namespace stridegraph
