#include "graph/clip_preparation.h"

#include <fmt/format.h>

#include <cmath>

#include "motion/resample.h"

namespace stridegraph {
namespace {

double rounded(double value) {
  return static_cast<double>(static_cast<float>(value));
}

bool isSameRate(double clipRate, double libraryRate) {
  constexpr double kSameRate = 0.005;
  return std::abs(clipRate / libraryRate - 1.0) <= kSameRate;
}

}  // namespace

Clip atLibraryRate(const Clip& clip, double framesPerSecond) {
  if (!isSameRate(clip.framesPerSecond, framesPerSecond)) return resample(clip, framesPerSecond);
  Clip same = clip;
  same.framesPerSecond = framesPerSecond;
  makeSignsContinuous(same);
  return same;
}

std::size_t frameCountAtLibraryRate(const Clip& clip, double framesPerSecond) {
  if (isSameRate(clip.framesPerSecond, framesPerSecond)) return clip.frameCount();
  return resampledFrameCount(clip.frameCount(), clip.framesPerSecond, framesPerSecond);
}

double floorLiftMetres(double libraryFloorMetres, double clipFloorMetres) {
  constexpr double kSameFloorMetres = 0.01;
  const double lift = libraryFloorMetres - clipFloorMetres;
  return std::abs(lift) > kSameFloorMetres ? lift : 0.0;
}

Warning liftWarning(const std::string& clipName, double liftMetres) {
  return {fmt::format("its floor lies {:.1f} cm {} that of the first clip; it was {} to that",
                      100.0 * std::abs(liftMetres), liftMetres < 0.0 ? "above" : "below",
                      liftMetres < 0.0 ? "lowered" : "raised"),
          {clipName},
          WarningTopic::kMotion};
}

void roundToFloats(const Skeleton& skeleton, Clip& clip) {
  for (Vec3& root : clip.rootPositions) root = root.unaryExpr(&rounded);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::span<Quat> rotations = clip.rotationsOf(f);
    for (std::size_t j = 0; j < rotations.size(); ++j) {
      Quat& q = rotations[j];
      q = skeleton.joints[j].isEndSite ? Quat::Identity()
                                       : Quat(rounded(q.w()), rounded(q.x()), rounded(q.y()), rounded(q.z()));
    }
  }
}

}  // namespace stridegraph
