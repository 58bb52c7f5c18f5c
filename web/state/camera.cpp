#include "state/camera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridegraph {

namespace {

constexpr double kPerspectiveRadians = 0.6;
constexpr double kPlanRadians = 0.05;  // Narrow enough that walls show no sides, wide enough for depth.
constexpr double kLowestPitch = 0.08;
constexpr double kHighestPitch = std::numbers::pi / 2.0;

Vec3 forwardOf(const CameraPose& pose) {
  const double flat = std::cos(pose.pitchRadians);
  return {flat * std::sin(pose.yawRadians), -std::sin(pose.pitchRadians), -flat * std::cos(pose.yawRadians)};
}

Vec3 rightOf(const CameraPose& pose) {
  return {std::cos(pose.yawRadians), 0.0, std::sin(pose.yawRadians)};
}

double distanceOf(const CameraPose& pose) {
  return pose.halfHeightMetres / std::tan(pose.fieldOfViewRadians / 2.0);
}

Eigen::Matrix4d perspective(double fieldOfView, double aspect, double near, double far) {
  const double scale = 1.0 / std::tan(fieldOfView / 2.0);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = scale / aspect;
  m(1, 1) = scale;
  m(2, 2) = (far + near) / (near - far);
  m(2, 3) = 2.0 * far * near / (near - far);
  m(3, 2) = -1.0;
  return m;
}

double towards(double from, double to, double share) {
  return from + (to - from) * share;
}

}  // namespace

double Viewport::freeWidth() const {
  return std::max(width - left - right, 0.3 * width);
}

double Viewport::freeHeight() const {
  return std::max(height - top - bottom, 0.3 * height);
}

std::optional<Vec2> CameraView::project(const Vec3& point) const {
  const Eigen::Vector4d clip = clipFromWorld * point.homogeneous();
  if (clip.w() <= 1e-6) return std::nullopt;
  return Vec2((clip.x() / clip.w() * 0.5 + 0.5) * viewport.width,
              (0.5 - clip.y() / clip.w() * 0.5) * viewport.height);
}

Ray CameraView::rayAt(const Vec2& pointer) const {
  const double x = pointer.x() / viewport.width * 2.0 - 1.0;
  const double y = 1.0 - pointer.y() / viewport.height * 2.0;
  const Eigen::Vector4d far = worldFromClip * Eigen::Vector4d(x, y, 1.0, 1.0);
  return {eye, (far.head<3>() / far.w() - eye).normalized()};
}

double CameraView::metresPerPoint(const Vec3& point) const {
  const double depth = (clipFromWorld * point.homogeneous()).w();
  return std::max(depth, 1e-3) * 2.0 / (focalScale * viewport.height);
}

std::optional<Vec2> meetPlane(const Ray& ray, double heightMetres) {
  if (std::abs(ray.direction.y()) < 1e-9) return std::nullopt;
  const double along = (heightMetres - ray.origin.y()) / ray.direction.y();
  if (along <= 0.0) return std::nullopt;
  return onFloor(ray.origin + along * ray.direction);
}

CameraView viewOf(const CameraPose& pose, const Viewport& viewport) {
  const Vec3 forward = forwardOf(pose);
  const Vec3 right = rightOf(pose);
  const Vec3 up = right.cross(forward);
  const double distance = distanceOf(pose);
  CameraView view;
  view.viewport = viewport;
  view.eye = Vec3(pose.target.x(), pose.targetHeight, pose.target.y()) - distance * forward;
  Eigen::Matrix4d viewFromWorld = Eigen::Matrix4d::Identity();
  viewFromWorld.block<1, 3>(0, 0) = right.transpose();
  viewFromWorld.block<1, 3>(1, 0) = up.transpose();
  viewFromWorld.block<1, 3>(2, 0) = -forward.transpose();
  viewFromWorld.block<3, 1>(0, 3) = -(viewFromWorld.block<3, 3>(0, 0) * view.eye);
  const double near = std::max(0.05, distance - pose.halfHeightMetres * 6.0 - 8.0);
  const double far = distance + pose.halfHeightMetres * 12.0 + 120.0;
  const double aspect = viewport.width / std::max(viewport.height, 1.0);
  view.focalScale = 1.0 / std::tan(pose.fieldOfViewRadians / 2.0);
  Eigen::Matrix4d clipFromView = perspective(pose.fieldOfViewRadians, aspect, near, far);
  // A shifted lens: the target appears in the middle of what panels leave free.
  clipFromView.row(0) += (viewport.left - viewport.right) / viewport.width * clipFromView.row(3);
  clipFromView.row(1) += (viewport.bottom - viewport.top) / viewport.height * clipFromView.row(3);
  view.clipFromWorld = clipFromView * viewFromWorld;
  view.worldFromClip = view.clipFromWorld.inverse();
  return view;
}

namespace {

/// Moves and zooms a pose until the room, with something standing in it, just fills what panels leave free.
void fitRoom(CameraPose& pose, const Vec2& room, const Viewport& viewport) {
  constexpr double kStandingMetres = 1.0, kMargin = 1.05;
  constexpr int kRounds = 8;  // Perspective makes each round inexact; the error shrinks to nothing in a few.
  pose.halfHeightMetres = room.norm();
  for (int round = 0; round < kRounds; ++round) {
    const CameraView view = viewOf(pose, viewport);
    Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at((corner & 1) * room.x(), (corner >> 2) * kStandingMetres, (corner >> 1 & 1) * room.y());
      const std::optional<Vec2> shown = view.project(at);
      if (!shown) continue;
      low = low.cwiseMin(*shown);
      high = high.cwiseMax(*shown);
    }
    const Vec2 middle(viewport.left + viewport.freeWidth() / 2, viewport.top + viewport.freeHeight() / 2);
    const Vec2 off = (low + high) / 2 - middle;
    const double metresPerPoint = 2.0 * pose.halfHeightMetres / viewport.height;
    const Vec2 right(std::cos(pose.yawRadians), std::sin(pose.yawRadians));
    const Vec2 ahead(std::sin(pose.yawRadians), -std::cos(pose.yawRadians));
    pose.target += metresPerPoint * (off.x() * right - off.y() / std::sin(pose.pitchRadians) * ahead);
    const Vec2 span = high - low;
    pose.halfHeightMetres *=
        kMargin * std::max(span.x() / viewport.freeWidth(), span.y() / viewport.freeHeight());
  }
}

}  // namespace

CameraPose poseOverRoom(double widthMetres, double depthMetres, const Viewport& viewport) {
  CameraPose pose;
  pose.target = Vec2(widthMetres / 2.0, depthMetres / 2.0);
  pose.yawRadians = 0.35;
  pose.pitchRadians = 0.82;
  pose.fieldOfViewRadians = kPerspectiveRadians;
  fitRoom(pose, Vec2(widthMetres, depthMetres), viewport);
  return pose;
}

CameraPose poseAboveRoom(double widthMetres, double depthMetres, const Viewport& viewport) {
  CameraPose pose;
  pose.target = Vec2(widthMetres / 2.0, depthMetres / 2.0);
  pose.yawRadians = 0.0;
  pose.pitchRadians = kHighestPitch;
  pose.fieldOfViewRadians = kPlanRadians;
  fitRoom(pose, Vec2(widthMetres, depthMetres), viewport);
  return pose;
}

bool glide(Camera& camera, double deltaSeconds) {
  CameraPose& now = camera.current;
  const CameraPose& to = camera.wanted;
  const double share = 1.0 - std::exp(-9.0 * deltaSeconds);
  const double span = std::max(to.halfHeightMetres, 0.5);
  const double left = (to.target - now.target).norm() / span + std::abs(to.yawRadians - now.yawRadians) +
                      std::abs(to.pitchRadians - now.pitchRadians) +
                      std::abs(std::log(to.halfHeightMetres / now.halfHeightMetres)) +
                      std::abs(to.fieldOfViewRadians - now.fieldOfViewRadians) * 4.0;
  if (left < 2e-3) {
    now = to;
    return false;
  }
  now.target += (to.target - now.target) * share;
  now.targetHeight = towards(now.targetHeight, to.targetHeight, share);
  now.yawRadians = towards(now.yawRadians, to.yawRadians, share);
  now.pitchRadians = towards(now.pitchRadians, to.pitchRadians, share);
  now.halfHeightMetres *= std::pow(to.halfHeightMetres / now.halfHeightMetres, share);
  now.fieldOfViewRadians *= std::pow(to.fieldOfViewRadians / now.fieldOfViewRadians, share);
  return true;
}

void turn(Camera& camera, const Vec2& dragPoints) {
  if (camera.mode == CameraMode::kTop) return;
  camera.wanted.yawRadians -= dragPoints.x() * 0.006;
  camera.wanted.pitchRadians =
      std::clamp(camera.wanted.pitchRadians + dragPoints.y() * 0.005, kLowestPitch, kHighestPitch - 0.02);
}

void pan(Camera& camera, const Vec2& dragPoints, const Viewport& viewport) {
  const CameraPose& pose = camera.wanted;
  const double metresPerPoint = 2.0 * pose.halfHeightMetres / std::max(viewport.height, 1.0);
  const Vec2 right(std::cos(pose.yawRadians), std::sin(pose.yawRadians));
  const Vec2 ahead(std::sin(pose.yawRadians), -std::cos(pose.yawRadians));
  const double foreshortening = std::max(std::sin(pose.pitchRadians), 0.25);
  camera.wanted.target +=
      metresPerPoint * (-dragPoints.x() * right + dragPoints.y() / foreshortening * ahead);
}

void zoom(Camera& camera, double factor, const std::optional<Vec2>& about) {
  CameraPose& pose = camera.wanted;
  const double before = pose.halfHeightMetres;
  pose.halfHeightMetres = std::clamp(before * factor, 0.6, 200.0);
  if (about && camera.mode != CameraMode::kFollow) {
    pose.target = *about + (pose.target - *about) * (pose.halfHeightMetres / before);
  }
}

}  // namespace stridegraph
