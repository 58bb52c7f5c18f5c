#include "made_scene.h"

namespace stridegraph::fuzz {
namespace {

Vec2 madePoint(Input& input, const Scene& room) {
  const double x = input.oddNumber(0.0, room.widthMetres);
  return {x, input.oddNumber(0.0, room.depthMetres)};
}

Placement madePlacement(Input& input, const Scene& room) {
  Placement placement{madePoint(input, room), {}};
  if (input.chance()) placement.heading = Angle::degrees(input.oddNumber(-180.0, 180.0));
  return placement;
}

MovingObstacle madeMoving(Input& input, const Scene& room) {
  constexpr TrackRepeat kRepeats[] = {TrackRepeat::kLoop, TrackRepeat::kPingPong, TrackRepeat::kOnce};
  MovingObstacle moving;
  moving.size = {input.oddNumber(0.05, 2.0), input.oddNumber(0.05, 2.0)};
  moving.repeat = kRepeats[input.below(3)];
  double seconds = input.oddNumber(-2.0, 2.0);
  for (std::size_t points = 1 + input.below(5); points > 0; --points) {
    moving.track.push_back({seconds, madePoint(input, room)});
    seconds += input.oddNumber(0.01, 6.0);
  }
  return moving;
}

WalkConstraints madeConstraints(Input& input, const Scene& room) {
  WalkConstraints constraints;
  const unsigned what = input.byte();
  if ((what & 1U) != 0) constraints.gait = (what & 2U) != 0 ? Gait::kRun : Gait::kWalk;
  if ((what & 4U) != 0) constraints.minSpeedMetresPerSecond = input.oddNumber(0.0, 2.0);
  if ((what & 8U) != 0) constraints.maxSpeedMetresPerSecond = input.oddNumber(0.0, 4.0);
  if ((what & 16U) != 0) constraints.latestArrivalSeconds = input.oddNumber(0.1, 60.0);
  for (std::size_t areas = (what >> 5U) % 4; areas > 0; --areas) {
    const AreaKind kind = input.chance() ? AreaKind::kPrefer : AreaKind::kAvoid;
    constraints.areas.push_back({madeBlock(input, room), kind});
  }
  return constraints;
}

}  // namespace

Rectangle madeBlock(Input& input, const Scene& room) {
  const Vec2 centre = madePoint(input, room);
  const double width = input.oddNumber(0.01, room.widthMetres / 2.0);
  return {centre, {width, input.oddNumber(0.01, room.depthMetres / 2.0)}};
}

Scene madeScene(Input& input) {
  Scene scene;
  const double scale = input.below(16) == 15 ? 4.0 : 1.0;
  scene.widthMetres = scale * input.oddNumber(1.0, 16.0);
  scene.depthMetres = scale * input.oddNumber(1.0, 16.0);
  scene.radiusMetres = input.oddNumber(0.05, 0.6);
  scene.seed = input.byte();
  scene.start = madePlacement(input, scene);
  scene.goal = madePlacement(input, scene);
  for (std::size_t count = input.below(9); count > 0; --count)
    scene.obstacles.push_back(madeBlock(input, scene));
  for (std::size_t count = input.below(4); count > 0; --count)
    scene.moving.push_back(madeMoving(input, scene));
  for (std::size_t count = input.below(4); count > 0; --count) {
    const Placement start = madePlacement(input, scene);
    scene.walkers.push_back({start, madePlacement(input, scene)});
  }
  scene.constraints = madeConstraints(input, scene);
  return scene;
}

}  // namespace stridegraph::fuzz
