#include "figures/foot_traces.h"

#include <algorithm>
#include <cmath>

#include "figures/palette.h"
#include "motion/kinematics.h"

namespace stridegraph::figures {

Vec3 FootTraces::velocity(std::size_t frame, JointIndex joint) const {
  const std::size_t before = frame > 0 ? frame - 1 : 0;
  const std::size_t after = std::min(frame + 1, frameCount() - 1);
  const Vec3 way = positions[after][joint.value] - positions[before][joint.value];
  return way * framesPerSecond / static_cast<double>(after - before);
}

FootTraces footTraces(const MotionLibrary& library, const Clip& walk, double seconds) {
  FootTraces traces{walk.framesPerSecond, {}};
  const auto frames = static_cast<std::size_t>(std::lround(seconds * walk.framesPerSecond)) + 1;
  for (std::size_t f = 0; f < std::min(walk.frameCount(), frames); ++f)
    traces.positions.push_back(jointPositions(library.skeleton, walk.pose(f)));
  return traces;
}

std::vector<FrameRun> runsOf(std::span<const ContactMask> contacts, ContactMask mask) {
  std::vector<FrameRun> runs;
  for (std::size_t f = 0; f < contacts.size(); ++f) {
    if ((contacts[f] & mask) == 0) continue;
    const std::size_t first = f;
    while (f + 1 < contacts.size() && (contacts[f + 1] & mask) != 0) ++f;
    runs.push_back({first, f});
  }
  return runs;
}

void drawStances(Svg& svg, const Axes& axes, const FootTraces& traces, std::span<const FrameRun> stances) {
  for (const FrameRun& run : stances) {
    const double left = axes.at(traces.secondsAt(run.first), 0.0).x();
    const double right = axes.at(traces.secondsAt(run.last), 0.0).x();
    svg.rectangle({left, axes.frame().top, right, axes.frame().bottom}, {.fill = palette::kGrown});
  }
}

Scene straightWalkScene() {
  Scene scene;
  scene.name = "straight on";
  scene.widthMetres = 12.0;
  scene.depthMetres = 5.0;
  scene.start = {{1.2, 2.5}, Angle::degrees(90.0)};
  scene.goal = {{10.4, 2.5}, Angle::degrees(90.0)};
  return scene;
}

}  // namespace stridegraph::figures
