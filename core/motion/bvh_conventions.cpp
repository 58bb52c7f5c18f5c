#include "motion/bvh_conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr std::size_t kMostMeasuredFrames = 101;
/// How much further a body must reach along one axis than along another to stand along it.
constexpr double kClearlyLonger = 1.25;
constexpr double kTypicalHeightMetres = 1.5;
constexpr double kLowestHeightMetres = 0.9;
constexpr double kGreatestHeightMetres = 2.4;
constexpr double kCentimetresPerMetre = 100.0;

struct Unit {
  std::string_view name;
  double perMetre;
};
constexpr double kInchesPerMetre = 1.0 / 0.0254;
constexpr std::array<Unit, 5> kUnits = {{{"metres", 1.0},
                                         {"CMU units of 5.6444 cm", 0.45 * kInchesPerMetre},
                                         {"inches", kInchesPerMetre},
                                         {"centimetres", kCentimetresPerMetre},
                                         {"millimetres", 1000.0}}};

Vec3 extentOf(const Skeleton& skeleton, const PoseView& pose) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const Vec3& position : jointPositions(skeleton, pose)) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  return high - low;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double along(UpAxis up, const Vec3& extent) {
  return up == UpAxis::kY ? extent.y() : extent.z();
}

}  // namespace

BodyExtents measureExtents(const Skeleton& skeleton, const Clip& clip) {
  BodyExtents extents;
  const Pose rest{Vec3::Zero(), std::vector<Quat>(skeleton.size(), Quat::Identity())};
  extents.rest = extentOf(skeleton, rest.view());
  const std::size_t measured = std::min(clip.frameCount(), kMostMeasuredFrames);
  if (measured == 0) return extents;
  std::array<std::vector<double>, 3> reaches;
  for (std::size_t i = 0; i < measured; ++i) {
    const Vec3 extent = extentOf(skeleton, clip.pose(i * clip.frameCount() / measured));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reaches[axis].push_back(extent[static_cast<Eigen::Index>(axis)]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extents.posed[static_cast<Eigen::Index>(axis)] = medianOf(std::move(reaches[axis]));
  }
  return extents;
}

UpAxis inferUpAxis(const BodyExtents& extents, Warnings& warnings) {
  const double y = extents.posed.y();
  const double z = extents.posed.z();
  if (y > kClearlyLonger * z || (y == 0.0 && z == 0.0)) return UpAxis::kY;
  if (z > kClearlyLonger * y) {
    warnings.push_back({fmt::format(
        "z is understood as up: the body reaches {:.4g} units along z and {:.4g} along y", z, y)});
    return UpAxis::kZ;
  }
  const UpAxis up = extents.rest.z() > kClearlyLonger * extents.rest.y() ? UpAxis::kZ : UpAxis::kY;
  warnings.push_back({fmt::format(
      "{} is taken as up, which the motion leaves open: the body reaches {:.4g} units along y and "
      "{:.4g} along z",
      up == UpAxis::kY ? "y" : "z", y, z)});
  return up;
}

double inferUnitsPerMetre(const BodyExtents& extents, UpAxis up, Warnings& warnings) {
  const double height = std::max(along(up, extents.posed), along(up, extents.rest));
  if (height < 1e-6) {
    warnings.push_back({"centimetres are taken as the unit: the body has no height to tell it from"});
    return kCentimetresPerMetre;
  }
  const auto strangeness = [&](const Unit& unit) {
    return std::abs(std::log(height / unit.perMetre / kTypicalHeightMetres));
  };
  const Unit& unit = *std::min_element(kUnits.begin(), kUnits.end(), [&](const Unit& a, const Unit& b) {
    return strangeness(a) < strangeness(b);
  });
  const double metres = height / unit.perMetre;
  const bool isOdd = metres < kLowestHeightMetres || metres > kGreatestHeightMetres;
  if (isOdd || unit.perMetre != kCentimetresPerMetre) {
    warnings.push_back(
        {fmt::format("{} are understood as the unit: the body is {:.4g} units tall, which is {:.3g} m{}",
                     unit.name, height, metres, isOdd ? ", odd for a human" : "")});
  }
  return unit.perMetre;
}

Vec3 coreFromFile(UpAxis up, const Vec3& v) {
  return up == UpAxis::kY ? v : Vec3(v.x(), v.z(), -v.y());
}

Vec3 fileFromCore(UpAxis up, const Vec3& v) {
  return up == UpAxis::kY ? v : Vec3(v.x(), -v.z(), v.y());
}

// A change of axes turns a rotation's axis and leaves its angle.
Quat coreFromFile(UpAxis up, const Quat& rotation) {
  const Vec3 axis = coreFromFile(up, Vec3(rotation.vec()));
  return {rotation.w(), axis.x(), axis.y(), axis.z()};
}

Quat fileFromCore(UpAxis up, const Quat& rotation) {
  const Vec3 axis = fileFromCore(up, Vec3(rotation.vec()));
  return {rotation.w(), axis.x(), axis.y(), axis.z()};
}

void convertToMetresYUp(UpAxis up, double unitsPerMetre, Skeleton& skeleton, Clip& clip) {
  for (Joint& joint : skeleton.joints) joint.offset = coreFromFile(up, joint.offset) / unitsPerMetre;
  for (Vec3& position : clip.rootPositions) position = coreFromFile(up, position) / unitsPerMetre;
  for (Quat& rotation : clip.rotations) rotation = coreFromFile(up, rotation);
}

}  // namespace stridegraph
