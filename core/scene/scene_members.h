#pragma once

#include <span>
#include <string_view>

namespace stridegraph {

/// The kinds of objects in a scene's JSON. kNone is any value whose members do not matter: a number, a text,
/// a list of these, or what this version does not know.
enum class SceneObject {
  kNone,
  kScene,
  kPlacement,
  kObstacle,
  kMoving,
  kTrackPoint,
  kWalker,
  kConstraints,
  kArea
};

/// A member of a scene's JSON object: its name, and of what kind the object is that it holds, by itself or in
/// a list.
struct SceneMember {
  std::string_view name;
  SceneObject holds = SceneObject::kNone;
};

/// All members that this version knows of an object, in the order in which they are written; none of kNone.
std::span<const SceneMember> membersOf(SceneObject object);

/// The member of that name; null where the object has none.
const SceneMember* findMember(SceneObject object, std::string_view name);

/// Whether this version knows that member of the outer object; others are kept as they are.
inline bool isKnownSceneMember(std::string_view name) {
  return findMember(SceneObject::kScene, name) != nullptr;
}

}  // namespace stridegraph
