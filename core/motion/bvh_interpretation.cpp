#include "motion/bvh_interpretation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/body_evidence.h"
#include "motion/bvh_channels.h"
#include "motion/bvh_conventions.h"
#include "motion/bvh_limits.h"
#include "motion/bvh_still_part.h"
#include "motion/file_unit.h"
#include "motion/position_channels.h"
#include "motion/travelling_root.h"
#include "motion/up_axis.h"

namespace stridegraph {
namespace {

/// A joint whose distance from its parent changes by less only shakes by rounding or marker noise.
constexpr double kStillMetres = 0.005;

/// A hierarchy with its motion, and which joint travels.
struct ParsedMotion {
  const BvhHierarchy& hierarchy;
  const JointTranslations& translations;
  const TravellingRoot& parts;
};

/// The joints of the body, and how far each comes from its mean offset, in file units.
std::vector<double> buildSkeleton(const ParsedMotion& parsed, Skeleton& skeleton) {
  std::vector<double> deviations;
  for (const std::size_t j : parsed.parts.body) {
    const BvhJoint& source = parsed.hierarchy.joints[j];
    Joint joint{source.name, {}, Vec3::Zero(), source.isEndSite};
    double deviation = 0.0;
    if (j != parsed.parts.root) {
      const JointTranslations::Spread spread = parsed.translations.spreadOf(j);
      joint.parent = JointIndex(*source.parent - parsed.parts.root);
      joint.offset = spread.mean;
      deviation = spread.deviation;
    }
    deviations.push_back(deviation);
    skeleton.joints.push_back(std::move(joint));
  }
  return deviations;
}

void buildClip(const ParsedMotion& parsed, Clip& clip) {
  const std::size_t frameCount = parsed.translations.frameCount();
  clip.jointCount = parsed.parts.body.size();
  clip.rootPositions.reserve(frameCount);
  clip.rotations.reserve(frameCount * clip.jointCount);
  for (std::size_t f = 0; f < frameCount; ++f) {
    const JointPlacement root = placementInFile(parsed.hierarchy, parsed.translations, parsed.parts.root, f);
    clip.rootPositions.push_back(root.position);
    for (const std::size_t j : parsed.parts.body) {
      clip.rotations.push_back(j == parsed.parts.root
                                   ? root.rotation
                                   : rotationIn(parsed.hierarchy.joints[j], parsed.translations.row(f)));
    }
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
  if (twin == names.end()) return;
  warnings.push_back(
      {fmt::format("more than one joint is named \"{}\"", *twin), {}, WarningTopic::kSkeleton});
}

void warnOfMovingJoints(const BvhDocument& document, const std::vector<double>& deviations,
                        Warnings& warnings) {
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    const double metres = deviations[j] / document.layout.unitsPerMetre;
    if (metres <= kStillMetres) continue;
    warnings.push_back(
        {fmt::format("joint \"{}\" moves by up to {:.3g} m against its parent; its mean offset is used",
                     document.skeleton.joints[j].name, metres),
         {},
         WarningTopic::kSkeleton});
  }
}

/// Up axis and unit, as given or as the body tells; the skeleton and the clip still have those of the file.
void inferConventions(const BvhReadParams& params, BvhDocument& document, Warnings& warnings) {
  document.layout.up = params.up.value_or(UpAxis::kY);
  document.layout.unitsPerMetre = params.unitsPerMetre.value_or(1.0);
  document.confidence = {};
  if (params.up && params.unitsPerMetre) return;
  const BodyEvidence evidence = gatherEvidence(document.skeleton, document.clip);
  if (!params.up) {
    const UpGuess guess = inferUpAxis(evidence, warnings);
    document.layout.up = guess.up;
    document.confidence.up = guess.confidence;
  }
  if (!params.unitsPerMetre) {
    const UnitGuess guess = inferUnit(evidence, document.layout.up, warnings);
    document.layout.unitsPerMetre = guess.perMetre;
    document.confidence.unit = guess.confidence;
  }
}

}  // namespace

Result<BvhDocument> interpretBvh(BvhHierarchy hierarchy, BvhMotion motion, std::string_view name,
                                 const BvhReadParams& params) {
  if (motion.frameCount > kMostBvhRotations / hierarchy.joints.size()) {
    return fail(ErrorCode::kBvhValue,
                fmt::format("found {} frames of {} joints, expected at most {} rotations in all",
                            motion.frameCount, hierarchy.joints.size(), kMostBvhRotations),
                {std::string(name)});
  }
  BvhDocument document;
  document.warnings = std::move(motion.warnings);
  document.clip.name = name;
  document.clip.framesPerSecond = motion.framesPerSecond;
  Warnings odd;
  const JointTranslations translations(hierarchy, motion, odd);
  const TravellingRoot parts = findTravellingRoot(hierarchy, translations, odd);
  const ParsedMotion parsed{hierarchy, translations, parts};
  const std::vector<double> deviations = buildSkeleton(parsed, document.skeleton);
  buildClip(parsed, document.clip);

  warnOfEqualNames(document.skeleton, odd);
  inferConventions(params, document, odd);
  convertToMetresYUp(document.layout.up, document.layout.unitsPerMetre, document.skeleton, document.clip);
  warnOfMovingJoints(document, deviations, odd);
  document.layout.still =
      stillPartOf(hierarchy, translations, parts, document.layout.up, document.layout.unitsPerMetre);
  for (Warning& warning : odd) {
    warning.place.file = name;
    document.warnings.push_back(std::move(warning));
  }
  for (const std::size_t j : parts.body) {
    document.layout.channels.push_back(std::move(hierarchy.joints[j].channels));
    document.layout.endSiteNames.push_back(std::move(hierarchy.joints[j].endSiteName));
  }
  return document;
}

}  // namespace stridegraph
