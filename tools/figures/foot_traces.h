#pragma once

#include <span>
#include <vector>

#include "figures/axes.h"
#include "figures/planted_feet.h"
#include "graph/library.h"
#include "scene/scene.h"

namespace stridegraph::figures {

/// Joint positions of a walk's beginning, frame by frame.
struct FootTraces {
  double framesPerSecond = 30.0;
  std::vector<std::vector<Vec3>> positions;  ///< World, metres; one for each joint of the skeleton.

  std::size_t frameCount() const { return positions.size(); }
  double secondsAt(std::size_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
  double endSeconds() const { return secondsAt(frameCount() - 1); }
  /// How a joint moves at a frame, metres a second: from the frame before to the one after.
  Vec3 velocity(std::size_t frame, JointIndex joint) const;
};

/// The first seconds of a walk.
FootTraces footTraces(const MotionLibrary& library, const Clip& walk, double seconds);

/// A run of frames first..last.
struct FrameRun {
  std::size_t first = 0;
  std::size_t last = 0;
};
/// Where at least one bit of the mask is set.
std::vector<FrameRun> runsOf(std::span<const ContactMask> contacts, ContactMask mask);

/// Pale bands over the frame of a diagram of time while the foot stands.
void drawStances(Svg& svg, const Axes& axes, const FootTraces& traces, std::span<const FrameRun> stances);

/// A value over time, cut off at the frame.
void drawTrace(Svg& svg, const Axes& axes, const FootTraces& traces, const Style& style,
               const auto& valueAt) {
  std::vector<Vec2> points;
  for (std::size_t f = 0; f < traces.frameCount(); ++f)
    points.push_back(axes.at(traces.secondsAt(f), valueAt(f)));
  svg.beginClip(axes.frame());
  svg.polyline(points, style);
  svg.endClip();
}

/// Straight on for 9 m, from standing to standing: what pictures of feet look at.
Scene straightWalkScene();

}  // namespace stridegraph::figures
