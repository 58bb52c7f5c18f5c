#pragma once

#include <Eigen/Core>
#include <optional>

#include "math/types.h"

namespace stridegraph {

enum class CameraMode { kOrbit, kFollow, kTop };

/// Where the view looks and from where. Narrowing the field of view while keeping what is visible turns the
/// perspective into a plan view without a jump.
struct CameraPose {
  Vec2 target = Vec2::Zero();       ///< Floor point in the middle of the view, metres.
  double targetHeight = 0.0;        ///< Of the middle above the floor, metres.
  double yawRadians = 0.0;          ///< 0 looks along -z, so that a plan has x to the right and z downwards.
  double pitchRadians = 0.9;        ///< Downwards; pi / 2 looks straight at the floor.
  double halfHeightMetres = 8.0;    ///< What is visible above and below the target, at its depth.
  double fieldOfViewRadians = 0.6;  ///< Vertical.

  bool operator==(const CameraPose&) const = default;
};

/// A camera that glides from where it is to where it is wanted.
struct Camera {
  CameraMode mode = CameraMode::kOrbit;
  CameraPose current;
  CameraPose wanted;
  CameraPose orbit;  ///< What orbit returns to after follow or top.
};

/// The size of the view in points (CSS pixels), and how much of each side panels cover: the camera looks at
/// the middle of what is left.
struct Viewport {
  double width = 1.0;
  double height = 1.0;
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

  double freeWidth() const;
  double freeHeight() const;
  bool operator==(const Viewport&) const = default;
};

/// A half line in the world.
struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();
};

/// The camera's matrices for one frame.
struct CameraView {
  Eigen::Matrix4d clipFromWorld = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d worldFromClip = Eigen::Matrix4d::Identity();
  Vec3 eye = Vec3::Zero();
  Viewport viewport;
  double focalScale = 1.0;  ///< 1 / tan(half of the vertical field of view).

  /// Where a point of the world appears, in points from the upper left; empty behind the eye.
  std::optional<Vec2> project(const Vec3& point) const;
  Ray rayAt(const Vec2& pointer) const;
  /// Metres that one point covers at a place in the world.
  double metresPerPoint(const Vec3& point) const;
};

/// Where a ray meets the plane y = height, if it does so in front of its origin.
std::optional<Vec2> meetPlane(const Ray& ray, double heightMetres);

CameraView viewOf(const CameraPose& pose, const Viewport& viewport);

/// A pose that shows a whole room.
CameraPose poseOverRoom(double widthMetres, double depthMetres, const Viewport& viewport);
/// The same seen from straight above.
CameraPose poseAboveRoom(double widthMetres, double depthMetres, const Viewport& viewport);

/// Moves `current` towards `wanted`; returns whether it is still on its way.
bool glide(Camera& camera, double deltaSeconds);

/// Turns about the target by a drag of so many points.
void turn(Camera& camera, const Vec2& dragPoints);
/// Moves the target so that the floor follows the pointer.
void pan(Camera& camera, const Vec2& dragPoints, const Viewport& viewport);
/// Brings nearer (factor < 1) or farther, keeping the floor point `about` where it is on the screen.
void zoom(Camera& camera, double factor, const std::optional<Vec2>& about);

}  // namespace stridegraph
