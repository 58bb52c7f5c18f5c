#include "render/marks.h"

#include <algorithm>
#include <cmath>

#include "motion/kinematics.h"
#include "scene/track.h"
#include "state/items.h"
#include "state/playback.h"

namespace stridegraph {

namespace {

bool isAbove(const Skeleton& skeleton, JointIndex upper, JointIndex lower) {
  for (std::optional<JointIndex> at = lower; at; at = skeleton.joints[at->value].parent) {
    if (*at == upper) return true;
  }
  return false;
}

/// Where a foot stands and points while its joints touch the floor.
Footprint printAt(const MotionLibrary& library, const Plan& plan, const std::vector<std::size_t>& foot,
                  std::size_t first, std::size_t last) {
  const std::size_t middle = (first + last) / 2;
  const std::vector<Vec3> joints = jointPositions(library.skeleton, plan.walk.pose(middle));
  Vec2 back = onFloor(joints[library.contactJoints[foot.front()].value]);
  Vec2 front = onFloor(joints[library.contactJoints[foot.back()].value]);
  if (foot.size() == 1) {
    const JointIndex ankle = library.contactJoints[foot[0]];
    const std::vector<JointIndex> toes = library.skeleton.childrenOf(ankle);
    if (!toes.empty()) front = onFloor(joints[toes[0].value]);
  }
  Footprint print;
  print.firstFrame = first;
  print.heading = Heading::alongDirection(front - back);
  const Vec2 ahead = print.heading.direction();
  const double span = (front - back).norm();
  print.lengthMetres = std::clamp(span * 1.75, 0.20, 0.32);
  print.centre = back + ahead * (span * 0.52);
  const Vec2 fromRoot = print.centre - onFloor(plan.walk.rootPositions[middle]);
  const Heading facing = separateHeading(plan.walk.pose(middle).rotations[0]).heading - library.facingOffset;
  // Left is the cross of up and ahead: +x for somebody who faces +z.
  const Vec2 left(facing.cos, -facing.sin);
  print.left = fromRoot.dot(left) > 0.0;
  return print;
}

void addTrail(const Clip& walk, const Colour& colour, double widthMetres, FloorMarks& marks) {
  constexpr std::size_t kEvery = 3;
  const std::vector<Vec3>& roots = walk.rootPositions;
  for (std::size_t i = kEvery; i < roots.size(); i += kEvery) {
    marks.lines.push_back({onFloor(roots[i - kEvery]), onFloor(roots[i]), colour, widthMetres, 1.0});
  }
}

void addRoute(const AppState& state, const Palette& palette, FloorMarks& marks) {
  const Plan& plan = *state.plan;
  if (state.view.roadmap) {
    for (const auto& [from, to] : plan.roadmap) {
      marks.lines.push_back({from, to, palette.roadmap, 0.004, 1.0});
    }
  }
  if (state.view.path) {
    for (std::size_t i = 1; i < plan.path.size(); ++i) {
      marks.lines.push_back({plan.path[i - 1], plan.path[i], palette.path, 0.035, 2.0});
    }
  }
  if (state.view.trail) addTrail(plan.walk, palette.trail, 0.03, marks);
  if (state.view.subgoals) {
    for (const Vec2& subgoal : plan.subgoals) {
      marks.over.push_back({MarkKind::kDisc, subgoal, Vec2::Constant(0.09), {}, palette.floor, 0.0});
      marks.over.push_back({MarkKind::kRing, subgoal, Vec2::Constant(0.10), {}, palette.subgoal, 0.045});
    }
  }
}

void addPlacement(const Placement& placement, double radius, const Colour& colour, bool chosen,
                  std::vector<Mark>& marks) {
  const Vec2& at = placement.position;
  marks.push_back({MarkKind::kDisc, at, Vec2::Constant(radius), {}, colour.faded(0.16F), 0.0});
  marks.push_back({MarkKind::kRing, at, Vec2::Constant(radius), {}, colour, chosen ? 0.07 : 0.04});
  if (!placement.heading) {
    marks.push_back({MarkKind::kDisc, at, Vec2::Constant(0.1), {}, colour, 0.0});
    return;
  }
  const Heading heading = Heading::fromAngle(*placement.heading);
  const Vec2 tip = at + heading.direction() * (radius + 0.14);
  marks.push_back({MarkKind::kArrow, tip, Vec2(0.17, 0.12), heading, colour, 0.0});
}

/// Further walkers: ends in their own colour, the goal with a ring within, and a shade under whoever stands
/// there, since only the first body's own shade is cast by the light.
void addWalkers(const AppState& state, const Palette& palette, const Colour& shade, FloorMarks& marks) {
  const Scene& scene = state.shownScene();
  constexpr double kShadeMetres = 0.42;
  for (std::size_t walker = scene.walkers.size(); walker > 0; --walker) {
    const Walker& ends = scene.walkers[walker - 1];
    const Colour& colour = walkerColour(palette, walker);
    const bool chosen = state.selection.index == walker && isThere(scene, state.selection);
    const Plan* const plan = state.planOf(walker);
    if (state.view.trail && plan != nullptr) addTrail(plan->walk, colour, 0.018, marks);
    addPlacement(ends.goal, scene.radiusMetres, colour, chosen && state.selection.kind == ItemKind::kGoal,
                 marks.over);
    marks.over.push_back(
        {MarkKind::kRing, ends.goal.position, Vec2::Constant(0.55 * scene.radiusMetres), {}, colour, 0.04});
    addPlacement(ends.start, scene.radiusMetres, colour, chosen && state.selection.kind == ItemKind::kStart,
                 marks.over);
    if (const std::optional<Pose> pose = shownPose(state, walker)) {
      const Vec2 at = onFloor(pose->rootPosition);
      marks.over.push_back({MarkKind::kContactShade, at, Vec2::Zero(), {}, shade, kShadeMetres});
    }
  }
}

void addAreas(const AppState& state, const Palette& palette, FloorMarks& marks) {
  const std::vector<Area>& areas = state.shownScene().constraints.areas;
  constexpr double kStripeMetres = 0.4, kEdgeMetres = 0.03, kChosenEdgeMetres = 0.06;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const bool avoids = areas[i].kind == AreaKind::kAvoid;
    const Colour& colour = avoids ? palette.avoid : palette.prefer;
    const Rectangle& at = areas[i].rectangle;
    const bool chosen = state.selection == Item{ItemKind::kArea, i};
    marks.under.push_back({MarkKind::kHatch,
                           at.centre,
                           at.size / 2,
                           {},
                           colour.faded(avoids ? 0.30F : 0.20F),
                           avoids ? kStripeMetres : 0.0});
    marks.under.push_back({MarkKind::kOutline,
                           at.centre,
                           at.size / 2,
                           {},
                           colour.faded(chosen ? 1.0F : 0.55F),
                           chosen ? kChosenEdgeMetres : kEdgeMetres});
  }
}

/// The way of a moving block as a fine line, with what it covers at both ends while it is chosen.
void addTrack(const MovingObstacle& moving, bool chosen, const Palette& palette, FloorMarks& marks) {
  const std::vector<TrackPoint>& track = moving.track;
  const Colour colour = chosen ? palette.track : palette.track.faded(0.65F);
  for (std::size_t i = 1; i < track.size(); ++i) {
    marks.lines.push_back({track[i - 1].position, track[i].position, colour, 0.015, 1.0});
  }
  for (const TrackPoint& point : track) {
    marks.over.push_back({MarkKind::kDisc, point.position, Vec2::Constant(0.06), {}, colour, 0.0});
    if (!chosen) continue;
    marks.over.push_back({MarkKind::kOutline, point.position, moving.size / 2, {}, colour, 0.03});
  }
}

}  // namespace

std::vector<std::vector<std::size_t>> feetOf(const MotionLibrary& library) {
  std::vector<std::vector<std::size_t>> feet;
  for (std::size_t i = 0; i < library.contactJoints.size(); ++i) {
    const JointIndex joint = library.contactJoints[i];
    const auto belongs = [&](const std::vector<std::size_t>& foot) {
      const JointIndex first = library.contactJoints[foot.front()];
      return isAbove(library.skeleton, first, joint) || isAbove(library.skeleton, joint, first);
    };
    const auto foot = std::find_if(feet.begin(), feet.end(), belongs);
    if (foot == feet.end()) {
      feet.push_back({i});
    } else {
      foot->push_back(i);
    }
  }
  // Ankles first: parents come before children in a skeleton.
  for (std::vector<std::size_t>& foot : feet) {
    std::sort(foot.begin(), foot.end(), [&](std::size_t a, std::size_t b) {
      return library.contactJoints[a].value < library.contactJoints[b].value;
    });
  }
  return feet;
}

std::vector<Footprint> footprintsOf(const MotionLibrary& library, const Plan& plan) {
  std::vector<Footprint> prints;
  constexpr std::size_t kShortestStay = 3;
  for (const std::vector<std::size_t>& foot : feetOf(library)) {
    unsigned bits = 0;
    for (const std::size_t joint : foot) bits |= 1u << joint;
    std::size_t first = 0;
    bool down = false;
    for (std::size_t frame = 0; frame <= plan.contacts.size(); ++frame) {
      const bool touches = frame < plan.contacts.size() && (plan.contacts[frame] & bits) != 0;
      if (touches && !down) first = frame;
      if (!touches && down && frame - first >= kShortestStay) {
        prints.push_back(printAt(library, plan, foot, first, frame - 1));
      }
      down = touches;
    }
  }
  return prints;
}

std::vector<Rectangle> shownBlocks(const AppState& state) {
  const Scene& scene = state.shownScene();
  std::vector<Rectangle> blocks = scene.obstacles;
  for (const MovingObstacle& moving : scene.moving)
    blocks.push_back(rectangleAt(moving, state.shownSeconds()));
  return blocks;
}

FloorMarks marksOf(const AppState& state, const std::vector<Footprint>& footprints) {
  const Palette& palette = paletteFor(state.view.dark);
  const Scene& scene = state.shownScene();
  FloorMarks marks;
  const Colour shade = Colour::hex(0x101828, state.view.dark ? 0.42F : 0.26F);
  addAreas(state, palette, marks);
  for (const Rectangle& block : shownBlocks(state)) {
    marks.under.push_back({MarkKind::kContactShade, block.centre, block.size / 2, {}, shade, 0.5});
  }
  for (std::size_t i = 0; i < scene.moving.size(); ++i) {
    addTrack(scene.moving[i], state.selection == Item{ItemKind::kMoving, i}, palette, marks);
  }
  if (state.plan) addRoute(state, palette, marks);
  if (state.view.footprints) {
    for (const Footprint& print : footprints) {
      const double length = print.lengthMetres;
      marks.over.push_back({MarkKind::kFootprint, print.centre, Vec2(length * 0.19, length / 2),
                            print.heading, print.left ? palette.leftFoot : palette.rightFoot,
                            print.left ? -1.0 : 1.0});
    }
  }
  addWalkers(state, palette, shade, marks);
  addPlacement(scene.goal, scene.radiusMetres, palette.goal, state.selection == Item{ItemKind::kGoal, 0},
               marks.over);
  addPlacement(scene.start, scene.radiusMetres, palette.start, state.selection == Item{ItemKind::kStart, 0},
               marks.over);
  return marks;
}

}  // namespace stridegraph
