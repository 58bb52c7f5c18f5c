#pragma once

#include <span>

#include "math/types.h"
#include "motion/bvh_hierarchy.h"

namespace stridegraph {

bool isPosition(BvhChannel channel);
/// The axis that a channel shifts along or turns about: 0, 1, 2 for x, y, z.
Eigen::Index axisOf(BvhChannel channel);
bool hasPositionChannels(const BvhJoint& joint);

/// A joint's numbers in a row of MOTION, one for each of its channels.
std::span<const double> valuesIn(const BvhJoint& joint, std::span<const double> row);

/// What the joint's position channels say; zero along axes that have none. File units and axes.
Vec3 positionIn(const BvhJoint& joint, std::span<const double> row);
/// `vector` along the axes that have a position channel, zero along the others.
Vec3 alongChannels(const BvhJoint& joint, const Vec3& vector);
/// The joint's rotation channels multiplied in the order of the file.
Quat rotationIn(const BvhJoint& joint, std::span<const double> row);

}  // namespace stridegraph
