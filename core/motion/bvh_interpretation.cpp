#include "motion/bvh_interpretation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/bvh_conventions.h"

namespace stridegraph {
namespace {

constexpr std::size_t kMostRotations = 20'000'000;
/// A joint whose distance from its parent changes by less only shakes by rounding or marker noise.
constexpr double kStillMetres = 0.005;

bool isPosition(BvhChannel channel) {
  return channel <= BvhChannel::kZPosition;
}

Eigen::Index axisOf(BvhChannel channel) {
  return static_cast<Eigen::Index>(channel) % 3;
}

/// A joint's translation in one row: its position channels, and its OFFSET along axes that have none.
Vec3 translationIn(const BvhJoint& joint, const double* row) {
  Vec3 translation = joint.offset;
  for (std::size_t c = 0; c < joint.channels.size(); ++c) {
    if (isPosition(joint.channels[c])) translation[axisOf(joint.channels[c])] = row[joint.firstColumn + c];
  }
  return translation;
}

Quat rotationIn(const BvhJoint& joint, const double* row) {
  Quat rotation = Quat::Identity();
  for (std::size_t c = 0; c < joint.channels.size(); ++c) {
    if (isPosition(joint.channels[c])) continue;
    const Angle angle = Angle::degrees(row[joint.firstColumn + c]);
    rotation = rotation * axisRotation(static_cast<Axis>(axisOf(joint.channels[c])), angle);
  }
  return rotation;
}

/// A joint below the root that has position channels, as if it were fixed to its parent.
struct FixedOffset {
  Vec3 mean = Vec3::Zero();
  double greatestDeviation = 0.0;
};

FixedOffset fixedOffsetOf(const BvhJoint& joint, const BvhMotion& motion) {
  FixedOffset fixed;
  const auto count = static_cast<double>(motion.frameCount);
  for (std::size_t f = 0; f < motion.frameCount; ++f) {
    fixed.mean += translationIn(joint, &motion.values[f * motion.columns]) / count;
  }
  for (std::size_t f = 0; f < motion.frameCount; ++f) {
    const Vec3 apart = translationIn(joint, &motion.values[f * motion.columns]) - fixed.mean;
    fixed.greatestDeviation = std::max(fixed.greatestDeviation, apart.norm());
  }
  return fixed;
}

/// Distance from its mean that each joint reaches, in file units, while the skeleton is built.
std::vector<double> buildSkeleton(const BvhHierarchy& hierarchy, const BvhMotion& motion,
                                  Skeleton& skeleton) {
  std::vector<double> deviations(hierarchy.joints.size(), 0.0);
  for (std::size_t j = 0; j < hierarchy.joints.size(); ++j) {
    const BvhJoint& source = hierarchy.joints[j];
    Joint joint{source.name, {}, Vec3::Zero(), source.isEndSite};
    if (source.parent) {
      joint.parent = JointIndex(*source.parent);
      joint.offset = source.offset;
      if (std::any_of(source.channels.begin(), source.channels.end(), isPosition)) {
        const FixedOffset fixed = fixedOffsetOf(source, motion);
        joint.offset = fixed.mean;
        deviations[j] = fixed.greatestDeviation;
      }
    }
    skeleton.joints.push_back(std::move(joint));
  }
  return deviations;
}

void buildClip(const BvhHierarchy& hierarchy, const BvhMotion& motion, Clip& clip) {
  clip.framesPerSecond = motion.framesPerSecond;
  clip.jointCount = hierarchy.joints.size();
  clip.rootPositions.reserve(motion.frameCount);
  clip.rotations.reserve(motion.frameCount * clip.jointCount);
  for (std::size_t f = 0; f < motion.frameCount; ++f) {
    const double* const row = &motion.values[f * motion.columns];
    clip.rootPositions.push_back(translationIn(hierarchy.joints.front(), row));
    for (const BvhJoint& joint : hierarchy.joints) clip.rotations.push_back(rotationIn(joint, row));
  }
}

/// End sites are named after their parents and follow from these: they are not told of.
void warnOfEqualNames(const Skeleton& skeleton, Warnings& warnings) {
  std::vector<std::string_view> names;
  for (const Joint& joint : skeleton.joints) {
    if (!joint.isEndSite) names.push_back(joint.name);
  }
  std::sort(names.begin(), names.end());
  const auto twin = std::adjacent_find(names.begin(), names.end());
  if (twin != names.end()) warnings.push_back({fmt::format("more than one joint is named \"{}\"", *twin)});
}

void warnOfMovingJoints(const BvhDocument& document, const std::vector<double>& deviations,
                        Warnings& warnings) {
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    const double metres = deviations[j] / document.layout.unitsPerMetre;
    if (metres <= kStillMetres) continue;
    warnings.push_back(
        {fmt::format("joint \"{}\" moves by up to {:.3g} m against its parent; its mean offset is used",
                     document.skeleton.joints[j].name, metres)});
  }
}

}  // namespace

Result<BvhDocument> interpretBvh(BvhHierarchy hierarchy, BvhMotion motion, std::string_view name,
                                 const BvhReadParams& params) {
  if (motion.frameCount > kMostRotations / hierarchy.joints.size()) {
    return fail(ErrorCode::kBvhValue,
                fmt::format("found {} frames of {} joints, expected at most {} rotations in all",
                            motion.frameCount, hierarchy.joints.size(), kMostRotations),
                {std::string(name)});
  }
  BvhDocument document;
  document.warnings = std::move(motion.warnings);
  document.clip.name = name;
  const std::vector<double> deviations = buildSkeleton(hierarchy, motion, document.skeleton);
  buildClip(hierarchy, motion, document.clip);

  Warnings odd;
  warnOfEqualNames(document.skeleton, odd);
  const BodyExtents extents = measureExtents(document.skeleton, document.clip);
  document.layout.up = params.up ? *params.up : inferUpAxis(extents, odd);
  document.layout.unitsPerMetre =
      params.unitsPerMetre ? *params.unitsPerMetre : inferUnitsPerMetre(extents, document.layout.up, odd);
  convertToMetresYUp(document.layout.up, document.layout.unitsPerMetre, document.skeleton, document.clip);
  warnOfMovingJoints(document, deviations, odd);
  for (Warning& warning : odd) document.warnings.push_back({std::move(warning.message), {std::string(name)}});

  for (BvhJoint& joint : hierarchy.joints) {
    document.layout.channels.push_back(std::move(joint.channels));
    document.layout.endSiteNames.push_back(std::move(joint.endSiteName));
  }
  return document;
}

}  // namespace stridegraph
