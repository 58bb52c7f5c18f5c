#include "motion/bvh_conventions.h"

namespace stridegraph {

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
