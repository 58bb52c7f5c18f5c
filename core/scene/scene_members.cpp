#include "scene/scene_members.h"

#include <algorithm>
#include <array>

namespace stridegraph {
namespace {

constexpr std::array<SceneMember, 12> kScene = {{{"version"},
                                                 {"name"},
                                                 {"width"},
                                                 {"depth"},
                                                 {"obstacles", SceneObject::kObstacle},
                                                 {"moving", SceneObject::kMoving},
                                                 {"start", SceneObject::kPlacement},
                                                 {"goal", SceneObject::kPlacement},
                                                 {"walkers", SceneObject::kWalker},
                                                 {"constraints", SceneObject::kConstraints},
                                                 {"radius"},
                                                 {"seed"}}};
constexpr std::array<SceneMember, 3> kPlacement = {{{"x"}, {"z"}, {"heading_deg"}}};
constexpr std::array<SceneMember, 4> kObstacle = {{{"x"}, {"z"}, {"width"}, {"depth"}}};
constexpr std::array<SceneMember, 4> kMoving = {
    {{"width"}, {"depth"}, {"repeat"}, {"track", SceneObject::kTrackPoint}}};
constexpr std::array<SceneMember, 3> kTrackPoint = {{{"t"}, {"x"}, {"z"}}};
constexpr std::array<SceneMember, 2> kWalker = {
    {{"start", SceneObject::kPlacement}, {"goal", SceneObject::kPlacement}}};
constexpr std::array<SceneMember, 5> kConstraints = {
    {{"gait"}, {"min_speed_m_s"}, {"max_speed_m_s"}, {"latest_arrival_s"}, {"areas", SceneObject::kArea}}};
constexpr std::array<SceneMember, 5> kArea = {{{"x"}, {"z"}, {"width"}, {"depth"}, {"kind"}}};

}  // namespace

std::span<const SceneMember> membersOf(SceneObject object) {
  switch (object) {
    case SceneObject::kScene:
      return kScene;
    case SceneObject::kPlacement:
      return kPlacement;
    case SceneObject::kObstacle:
      return kObstacle;
    case SceneObject::kMoving:
      return kMoving;
    case SceneObject::kTrackPoint:
      return kTrackPoint;
    case SceneObject::kWalker:
      return kWalker;
    case SceneObject::kConstraints:
      return kConstraints;
    case SceneObject::kArea:
      return kArea;
    case SceneObject::kNone:
      break;
  }
  return {};
}

const SceneMember* findMember(SceneObject object, std::string_view name) {
  const std::span<const SceneMember> members = membersOf(object);
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const SceneMember& member) { return member.name == name; });
  return found == members.end() ? nullptr : &*found;
}

}  // namespace stridegraph
