#include "figures/soft_body.h"

#include <algorithm>
#include <cmath>

namespace stridegraph::figures {
namespace {

constexpr double kFarMetres = 10.0;
constexpr double kSoftnessPerRadius = 0.9;

double distanceToCapsule(const Capsule& capsule, const Vec3& point) {
  const Vec3 bone = capsule.to - capsule.from;
  const Vec3 way = point - capsule.from;
  const double share = std::clamp(way.dot(bone) / std::max(bone.squaredNorm(), 1e-12), 0.0, 1.0);
  const double radius = capsule.fromRadius + share * (capsule.toRadius - capsule.fromRadius);
  return (way - share * bone).norm() - radius;
}

double thinnest(const Capsule& capsule) {
  return std::min(capsule.fromRadius, capsule.toRadius);
}

}  // namespace

SoftBody::SoftBody(std::vector<Capsule> capsules) : capsules_(std::move(capsules)) {
  std::stable_sort(capsules_.begin(), capsules_.end(),
                   [](const Capsule& a, const Capsule& b) { return thinnest(a) > thinnest(b); });
}

double SoftBody::distance(const Vec3& point) const {
  double least = kFarMetres;
  for (const Capsule& capsule : capsules_) {
    const double next = distanceToCapsule(capsule, point);
    const double softness = kSoftnessPerRadius * thinnest(capsule);
    const double overlap = std::max(softness - std::abs(least - next), 0.0) / softness;
    least = std::min(least, next) - 0.25 * softness * overlap * overlap;
  }
  return least;
}

Vec3 SoftBody::normal(const Vec3& point) const {
  constexpr double kStepMetres = 2e-3;
  Vec3 gradient = Vec3::Zero();
  for (const Vec3& corner : {Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)})
    gradient += corner * distance(point + kStepMetres * corner);
  return gradient.normalized();
}

}  // namespace stridegraph::figures
