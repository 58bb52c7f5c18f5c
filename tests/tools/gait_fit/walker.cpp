#include "gait_fit/walker.h"

#include <algorithm>
#include <cmath>

#include "motion/kinematics.h"

namespace stridegraph::gait_fit::testing {

KnownWalk makeWalk(const Walk& walk, Gait gait) {
  constexpr double kFramesPerSecond = 30.0;
  KnownWalk known;
  known.clip.name = "known";
  known.clip.framesPerSecond = kFramesPerSecond;
  known.clip.jointCount = kGaitJointCount;
  double phase = walk.firstPhase;
  double heading = 0.4;
  Vec2 place(1.0, -2.0);
  constexpr double kStep = 1e-4;
  const auto slope = [](const auto& f, double t) { return (f(t + kStep) - f(t - kStep)) / (2.0 * kStep); };
  constexpr int kSubsteps = 20;
  const auto frames = static_cast<int>(walk.seconds * kFramesPerSecond);
  for (int i = 0; i <= frames * kSubsteps; ++i) {
    const double t = i / (kFramesPerSecond * kSubsteps);
    const double w = walk.turnRate(t);
    const GaitState state{phase, walk.speed(t), w, slope(walk.turnRate, t), slope(walk.speed, t)};
    if (i % kSubsteps == 0) {
      Pose pose = gaitPose(gait, state);
      const FloorTransform worldFromPath{place, Heading::fromAngle(Angle::radians(heading))};
      pose.rootPosition = worldFromPath.apply(pose.rootPosition);
      pose.rotations[0] = worldFromPath.heading.rotation() * pose.rotations[0];
      known.clip.append(pose.view());
      known.states.push_back(state);
    }
    const double dt = 1.0 / (kFramesPerSecond * kSubsteps);
    const Angle direction = Angle::radians(heading) + gaitSlip(gait, w, state.turnAcceleration);
    place += state.speed * dt * Heading::fromAngle(direction).direction();
    heading += w * dt;
    phase += gaitCadence(gait, state.speed, w) * dt;
  }
  return known;
}

std::vector<KnownWalk> variedWalks(Gait gait) {
  const double middle = gait == Gait::kWalk ? 1.3 : 2.6;
  std::vector<KnownWalk> walks;
  for (const double speed : {middle - 0.3, middle, middle + 0.3})
    for (const double turn : {-0.8, -0.3, 0.0, 0.3, 0.8})
      walks.push_back(makeWalk({4.0, [=](double t) { return speed + 0.1 * std::sin(1.3 * t); },
                                [=](double t) { return turn * std::sin(1.1 * t); }, speed + turn},
                               gait));
  return walks;
}

std::vector<Clip> clipsOf(const std::vector<KnownWalk>& walks) {
  std::vector<Clip> clips;
  for (const KnownWalk& walk : walks) clips.push_back(walk.clip);
  return clips;
}

double largestDistance(const Pose& a, const Pose& b) {
  const auto first = jointPositions(gaitSkeleton(), a.view());
  const auto second = jointPositions(gaitSkeleton(), b.view());
  double largest = 0.0;
  for (std::size_t j = 0; j < first.size(); ++j) largest = std::max(largest, (first[j] - second[j]).norm());
  return largest;
}

}  // namespace stridegraph::gait_fit::testing
