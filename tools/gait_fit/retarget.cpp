#include "gait_fit/retarget.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "gait_fit/body_roles.h"
#include "gait_fit/track.h"
#include "graph/glitches.h"
#include "math/rotation.h"
#include "motion/contacts.h"
#include "motion/gait_model.h"
#include "motion/kinematics.h"
#include "motion/resample.h"

namespace stridegraph::gait_fit {
namespace {

constexpr double kFramesPerSecond = 30.0;

/// For each joint of the gait body the one of the actor's that moves it; nothing for clavicles and toes.
std::array<std::optional<std::size_t>, kGaitJointCount> sources(const BodyRoles& roles) {
  std::array<std::optional<std::size_t>, kGaitJointCount> result;
  for (std::size_t j = 0; j < kStoredJointCount; ++j) {
    const GaitJoint joint = gaitJointOf(static_cast<StoredJoint>(j));
    result[indexOf(otherSide(joint))] = roles.right[j].value;
    result[indexOf(joint)] = roles.left[j].value;
  }
  return result;
}

/// The rotation nearest to a sum of rotations.
Quat nearestRotation(const Mat3& sum) {
  const Eigen::JacobiSVD<Mat3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return Quat(Mat3(svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose())).normalized();
}

/// Mean bearing of each joint against the way that the body goes, over the frames in which it goes.
class MeanBearings {
 public:
  explicit MeanBearings(std::size_t joints) : sums_(joints, Mat3::Zero()) {}
  void add(const Vec2& travel, const std::vector<JointPlacement>& placements) {
    const Quat bodyFromWorld = Heading::alongDirection(travel).rotation().conjugate();
    for (std::size_t j = 0; j < sums_.size(); ++j)
      sums_[j] += (bodyFromWorld * placements[j].rotation).toRotationMatrix();
    ++frames_;
  }
  bool empty() const { return frames_ == 0; }
  Quat of(std::size_t joint) const { return nearestRotation(sums_[joint]); }

 private:
  std::vector<Mat3> sums_;
  std::size_t frames_ = 0;
};

MeanBearings bearingsOfGait(Gait gait) {
  constexpr int kPhases = 36;
  const Skeleton skeleton = gaitSkeleton();
  MeanBearings bearings(skeleton.size());
  std::vector<JointPlacement> placements(skeleton.size());
  for (int i = 0; i < kPhases; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / kPhases;
    placeJoints(skeleton, gaitPose(gait, {phase, gaitTable(gait).referenceSpeed}).view(), placements);
    bearings.add({0.0, 1.0}, placements);
  }
  return bearings;
}

/// Turns each of the actor's joints' axes into those of the gait body's joint: actorFromGait.
class Axes {
 public:
  Axes(const Skeleton& skeleton, const BodyRoles& roles, const MeanBearings& actor, Gait gait) {
    const MeanBearings reference = bearingsOfGait(gait);
    const Skeleton body = gaitSkeleton();
    const auto source = sources(roles);
    for (std::size_t j = 0; j < kGaitJointCount; ++j)
      if (source[j]) axes_[j] = actor.of(*source[j]).conjugate() * reference.of(j);
    // Long bones are known in both: they have to agree.
    for (const bool left : {true, false})
      for (const auto& [upper, lower] : {std::pair{StoredJoint::kFemur, StoredJoint::kTibia},
                                         std::pair{StoredJoint::kTibia, StoredJoint::kFoot},
                                         std::pair{StoredJoint::kHumerus, StoredJoint::kRadius},
                                         std::pair{StoredJoint::kRadius, StoredJoint::kHand}}) {
        const GaitJoint from = left ? gaitJointOf(upper) : otherSide(gaitJointOf(upper));
        const GaitJoint to = left ? gaitJointOf(lower) : otherSide(gaitJointOf(lower));
        const Vec3& bone = skeleton.joints[*source[indexOf(to)]].offset;
        Quat& axes = axes_[indexOf(from)];
        axes = Quat::FromTwoVectors(axes * body.joints[indexOf(to)].offset, bone) * axes;
      }
  }
  const Quat& operator[](std::size_t joint) const { return axes_[joint]; }

 private:
  std::array<Quat, kGaitJointCount> axes_ = [] {
    std::array<Quat, kGaitJointCount> none;
    none.fill(Quat::Identity());
    return none;
  }();
};

double legLength(const Skeleton& skeleton, const BodyRoles& roles) {
  double length = 0.0;
  for (const StoredJoint joint : {StoredJoint::kTibia, StoredJoint::kFoot})
    length += skeleton.joints[roles.left[static_cast<std::size_t>(joint)].value].offset.norm();
  return length;
}

/// The actor's clip danced by the gait body.
Clip danced(const Clip& clip, const Skeleton& skeleton, const BodyRoles& roles, const Axes& axes) {
  const Skeleton body = gaitSkeleton();
  const auto source = sources(roles);
  const LegLengths legs = legLengths(body, gaitLeg(Side::kLeft));
  const double scale = legs.whole() / legLength(skeleton, roles);
  const Pose rest = gaitPose(Gait::kWalk, {});
  const std::size_t hip = static_cast<std::size_t>(StoredJoint::kFemur);
  Clip result{clip.name, clip.framesPerSecond, kGaitJointCount, {}, {}};
  std::vector<JointPlacement> placements(skeleton.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    placeJoints(skeleton, clip.pose(f), placements);
    Pose pose = rest;
    pose.rootPosition =
        0.5 * scale *
        (placements[roles.left[hip].value].position + placements[roles.right[hip].value].position);
    std::array<Quat, kGaitJointCount> world;
    for (std::size_t j = 0; j < kGaitJointCount; ++j) {
      const std::optional<JointIndex>& parent = body.joints[j].parent;
      const Quat carried = parent ? world[parent->value] : Quat::Identity();
      if (source[j])
        pose.rotations[j] = (carried.conjugate() * placements[*source[j]].rotation * axes[j]).normalized();
      world[j] = carried * pose.rotations[j];
    }
    result.append(pose.view());
  }
  return result;
}

/// Brings the toe ends of all clips, in their median, to where they touch the gait's floor.
void settle(std::vector<Clip>& clips) {
  std::vector<double> levels;
  for (const Clip& clip : clips) {
    const std::vector<double> ofJoints = jointLevelsMetres(gaitSkeleton(), clip);
    for (const GaitJoint toe : {GaitJoint::kLeftToesEnd, GaitJoint::kRightToesEnd})
      levels.push_back(ofJoints[indexOf(toe)]);
  }
  const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), middle, levels.end());
  for (Clip& clip : clips)
    for (Vec3& root : clip.rootPositions) root.y() += kGaitSoleMetres - *middle;
}

Result<std::vector<Clip>> retarget(const Skeleton& skeleton, const std::vector<Clip>& clips, Gait gait) {
  const Result<BodyRoles> roles = findBodyRoles(skeleton, clips);
  if (!roles) return tl::unexpected<Error>(roles.error());
  MeanBearings bearings(skeleton.size());
  std::vector<JointPlacement> placements(skeleton.size());
  for (const Clip& clip : clips)
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const Vec2 travel = travelAt(clip, f);
      if (travel.isZero()) continue;
      placeJoints(skeleton, clip.pose(f), placements);
      bearings.add(travel, placements);
    }
  if (bearings.empty())
    return fail(ErrorCode::kClipTooShort, "found nobody who goes anywhere, expected walks or jogs");
  const Axes axes(skeleton, *roles, bearings, gait);
  std::vector<Clip> result;
  for (const Clip& clip : clips) result.push_back(danced(clip, skeleton, *roles, axes));
  settle(result);
  return result;
}

}  // namespace

Result<std::vector<Clip>> onGaitBody(const Skeleton& skeleton, std::span<const Clip> clips, Gait gait) {
  std::vector<Clip> even;
  for (const Clip& clip : clips) {
    const Clip resampled = resample(clip, kFramesPerSecond);
    std::vector<Clip> pieces = cutAtGlitches(resampled, findGlitches(resampled));
    const bool isWhole = pieces.size() == 1;
    for (Clip& piece : pieces)
      if (isWhole || piece.frameCount() >= kShortestClip) even.push_back(std::move(piece));
  }
  if (even.empty() || differenceBetween(skeleton, gaitSkeleton()).empty()) return even;
  return retarget(skeleton, even, gait);
}

}  // namespace stridegraph::gait_fit
