#include "graph/clip_preparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/contacts.h"
#include "motion/resample.h"

namespace stridegraph {
namespace {

double rounded(double value) {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

Clip atLibraryRate(const Clip& clip, double framesPerSecond) {
  constexpr double kSameRate = 0.005;
  if (std::abs(clip.framesPerSecond / framesPerSecond - 1.0) > kSameRate)
    return resample(clip, framesPerSecond);
  Clip same = clip;
  same.framesPerSecond = framesPerSecond;
  makeSignsContinuous(same);
  return same;
}

Warnings levelFloors(const Skeleton& skeleton, std::span<Clip> clips) {
  constexpr double kSameFloorMetres = 0.01;
  const FootJoints feet = findFootJoints(skeleton, clips);
  std::vector<double> levels;
  for (const Clip& clip : clips) levels.push_back(floorLevelMetres(skeleton, clip, feet.joints));
  std::vector<double> sorted = levels;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[(sorted.size() - 1) / 2];
  Warnings warnings;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const double lift = middle - levels[c];
    if (std::abs(lift) <= kSameFloorMetres) continue;
    for (Vec3& root : clips[c].rootPositions) root.y() += lift;
    warnings.push_back(
        {fmt::format("its floor lies {:.1f} cm {} that of the other clips; it was {} to theirs",
                     100.0 * std::abs(lift), lift < 0.0 ? "above" : "below",
                     lift < 0.0 ? "lowered" : "raised"),
         {clips[c].name}});
  }
  return warnings;
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
