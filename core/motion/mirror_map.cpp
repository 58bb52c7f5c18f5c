#include "motion/mirror_map.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "math/floor_transform.h"
#include "motion/kinematics.h"
#include "motion/mirror.h"
#include "motion/mirror_pairs.h"

namespace stridegraph {
namespace {

/// Bones that differ from their partners' reflection by less than this share of all bones' lengths in sum are
/// those of one body with symmetric rest axes: people are not quite symmetric.
constexpr double kSymmetricShareOfBones = 0.1;
/// How much a joint's twist counts beside its bones' directions where it has several.
constexpr double kTwistWeight = 1e-6;

/// The rotation R for which the trace of R^T `m` is greatest (Wahba's problem, by the decomposition of
/// Markley 1988).
Quat nearestRotation(const Mat3& m) {
  const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return Quat(Mat3(svd.matrixU() * Vec3(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose()))
      .normalized();
}

Mat3 reflection(const Vec3& planeNormal) {
  return Mat3::Identity() - 2.0 * planeNormal * planeNormal.transpose();
}

/// True when the rest pose is symmetric about the plane of this normal.
bool isSymmetricAbout(const Skeleton& skeleton, const std::vector<JointIndex>& partner,
                      const Vec3& planeNormal) {
  double apart = 0.0;
  double lengths = 0.0;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Vec3& offset = skeleton.joints[j].offset;
    apart += (reflection(planeNormal) * skeleton.joints[partner[j].value].offset - offset).norm();
    lengths += offset.norm();
  }
  return apart < kSymmetricShareOfBones * lengths;
}

/// Pairs of joints that hang on the body's middle, bones of no length left out: hips, shoulders.
std::vector<std::size_t> firstOfSides(const Skeleton& skeleton, const std::vector<JointIndex>& partner) {
  std::vector<std::size_t> first;
  std::vector<bool> isMiddle(skeleton.size(), true);
  for (std::size_t j = 1; j < skeleton.size(); ++j) {
    const bool hangsOnMiddle = isMiddle[skeleton.joints[j].parent->value];
    const bool hasPartner = partner[j] != JointIndex(j);
    const bool hasLength = skeleton.joints[j].offset.norm() > 1e-9;
    isMiddle[j] = hangsOnMiddle && (!hasPartner || !hasLength);
    if (hangsOnMiddle && hasPartner && hasLength && JointIndex(j) < partner[j]) first.push_back(j);
  }
  return first;
}

/// Each joint's mean rotation against a frame that goes with the body: x from side to side, y up.
class MeanPose {
 public:
  MeanPose(const Skeleton& skeleton, const std::vector<JointIndex>& partner)
      : skeleton_(skeleton),
        partner_(partner),
        sides_(firstOfSides(skeleton, partner)),
        sums_(skeleton.size(), Mat3::Zero()) {}

  void add(const PoseView& pose) {
    std::vector<JointPlacement> placements(skeleton_.size());
    placeJoints(skeleton_, pose, placements);
    Vec2 across = Vec2::Zero();
    for (const std::size_t j : sides_) {
      across += onFloor(placements[j].position - placements[partner_[j].value].position);
    }
    if (across.norm() < 1e-6) return;
    // The heading that turns x into `across` is that of the direction a quarter turn before it.
    const Quat bodyFromWorld = Heading::alongDirection({-across.y(), across.x()}).rotation().conjugate();
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      sums_[j] += (bodyFromWorld * placements[j].rotation).toRotationMatrix();
    }
  }

  Quat rotation(std::size_t joint) const { return nearestRotation(sums_[joint]); }

 private:
  const Skeleton& skeleton_;
  const std::vector<JointIndex>& partner_;
  std::vector<std::size_t> sides_;
  std::vector<Mat3> sums_;
};

/// Turns as they would be if bones did not matter: from the symmetry of the rest pose or of the mean pose.
std::vector<Quat> twists(const Skeleton& skeleton, const std::vector<JointIndex>& partner,
                         std::span<const Clip> clips) {
  for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
    if (!isSymmetricAbout(skeleton, partner, normal)) continue;
    const Mat3 turn = reflection(Vec3::UnitX()) * reflection(normal);
    return std::vector<Quat>(skeleton.size(), Quat(turn));
  }
  MeanPose mean(skeleton, partner);
  for (const Clip& clip : clips) {
    for (std::size_t f = 0; f < clip.frameCount(); ++f) mean.add(clip.pose(f));
  }
  std::vector<Quat> result;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    result.push_back(mirrored(mean.rotation(partner[j].value)).conjugate() * mean.rotation(j));
  }
  return result;
}

/// `twist` turned so that the joint's bones, `bones`, point as `targets` do.
Quat alignedTo(const std::vector<Vec3>& bones, const std::vector<Vec3>& targets, const Quat& twist) {
  if (bones.empty()) return twist;
  if (bones.size() == 1) return (Quat::FromTwoVectors(twist * bones[0], targets[0]) * twist).normalized();
  Mat3 agreement = Mat3::Zero();
  double weight = 0.0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    agreement += targets[i] * (twist * bones[i]).transpose();
    weight += bones[i].norm() * targets[i].norm();
  }
  agreement += kTwistWeight * weight * Mat3::Identity();
  return (nearestRotation(agreement) * twist).normalized();
}

}  // namespace

Result<MirrorMap> findMirrorMap(const Skeleton& skeleton, std::span<const Clip> clips) {
  MirrorMap map;
  map.partner = pairJointsByName(skeleton);
  for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
    if (map.partner.empty()) map.partner = pairJointsByRestPose(skeleton, normal);
  }
  if (map.partner.empty()) {
    return fail(
        ErrorCode::kInvalidArgument,
        "found no left and right joints to mirror, expected names such as LeftArm and RightArm or a rest "
        "pose that is symmetric about x = 0 or z = 0");
  }
  const std::vector<Quat> twist = twists(skeleton, map.partner, clips);
  std::vector<std::vector<Vec3>> bones(skeleton.size());
  std::vector<std::vector<Vec3>> targets(skeleton.size());
  for (std::size_t j = 1; j < skeleton.size(); ++j) {
    const Vec3& bone = skeleton.joints[j].offset;
    const Vec3 target = mirrored(skeleton.joints[map.partner[j].value].offset);
    if (bone.norm() < 1e-9 || target.norm() < 1e-9) continue;
    bones[skeleton.joints[j].parent->value].push_back(bone);
    targets[skeleton.joints[j].parent->value].push_back(target);
  }
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const bool isEndSite = skeleton.joints[j].isEndSite;
    map.correction.push_back(isEndSite ? Quat::Identity() : alignedTo(bones[j], targets[j], twist[j]));
  }
  return map;
}

}  // namespace stridegraph
