#include "motion/bvh_layout.h"

namespace stridegraph {

BvhLayout standardBvhLayout(const Skeleton& skeleton) {
  BvhLayout layout;
  layout.endSiteNames.resize(skeleton.size());
  for (const Joint& joint : skeleton.joints) {
    std::vector<BvhChannel>& channels = layout.channels.emplace_back();
    if (joint.isEndSite) continue;
    if (!joint.parent) channels = {BvhChannel::kXPosition, BvhChannel::kYPosition, BvhChannel::kZPosition};
    channels.insert(channels.end(), {BvhChannel::kZRotation, BvhChannel::kXRotation, BvhChannel::kYRotation});
  }
  return layout;
}

}  // namespace stridegraph
