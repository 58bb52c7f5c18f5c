#include "bench/varied_clips.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "motion/resample.h"

namespace stridegraph::bench {
namespace {

constexpr double kMostPaceChange = 0.06;
constexpr double kStrayDegrees = 1.5;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Turns a joint about its three axes, each as a slow sine of its own.
void stray(Clip& clip, std::size_t joint, Random& random) {
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const double cyclesPerFrame = random.uniform(0.2, 1.0) / clip.framesPerSecond;
    const double phase = random.uniform();
    const Angle amplitude = Angle::degrees(random.uniform(0.0, kStrayDegrees));
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const double swing = std::sin(kTwoPi * (cyclesPerFrame * static_cast<double>(f) + phase));
      Quat& rotation = clip.rotationsOf(f)[joint];
      rotation = (rotation * axisRotation(axis, amplitude * swing)).normalized();
    }
  }
}

Clip takeOf(const Clip& clip, const Skeleton& skeleton, Random& random) {
  Clip take =
      resample(clip, clip.framesPerSecond * (1.0 + random.uniform(-kMostPaceChange, kMostPaceChange)));
  take.framesPerSecond = clip.framesPerSecond;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (!skeleton.joints[j].isEndSite) stray(take, j, random);
  }
  return take;
}

}  // namespace

std::vector<BvhDocument> variedGaitClips(std::size_t frames, std::uint64_t seed) {
  const std::vector<Clip> clips = defaultGaitClips();
  const Skeleton skeleton = gaitSkeleton();
  Random random(seed);
  std::vector<BvhDocument> takes;
  for (std::size_t count = 0; count < frames;) {
    const Clip& clip = clips[takes.size() % clips.size()];
    Clip take = takeOf(clip, skeleton, random);
    take.name = fmt::format("{} take {}", clip.name, 1 + takes.size() / clips.size());
    count += take.frameCount();
    takes.push_back({skeleton, gaitBvhLayout(), std::move(take), {}});
  }
  return takes;
}

}  // namespace stridegraph::bench
