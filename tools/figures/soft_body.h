#pragma once

#include <vector>

#include "math/types.h"
#include "motion/round_body.h"

namespace stridegraph::figures {

/// The surface of round cones that run into each other, by its distance (smooth union of signed distance
/// fields, Quilez 2013: polynomial smooth minimum). Thick parts run into each other widely, thin ones hardly.
class SoftBody {
 public:
  explicit SoftBody(std::vector<Capsule> capsules);

  /// A part of the body that is enough where only some capsules are near; `keep` picks them.
  template <typename Keep>
  SoftBody part(const Keep& keep) const {
    SoftBody some;
    for (const Capsule& capsule : capsules_) {
      if (keep(capsule)) some.capsules_.push_back(capsule);
    }
    return some;
  }
  bool empty() const { return capsules_.empty(); }
  const std::vector<Capsule>& capsules() const { return capsules_; }

  /// Metres from the surface, negative inside; never much more than the true distance.
  double distance(const Vec3& point) const;
  /// Unit vector away from the surface.
  Vec3 normal(const Vec3& point) const;

 private:
  SoftBody() = default;
  std::vector<Capsule> capsules_;  ///< Thickest first.
};

}  // namespace stridegraph::figures
