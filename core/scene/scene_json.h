#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace stridegraph {

/// Reads a scene: {"version": 1, "name": "...", "width": 20, "depth": 12, "obstacles": [{"x": 10, "z": 2,
/// "width": 1, "depth": 7}], "moving": [{"width": 1, "depth": 1, "repeat": "pingpong", "track": [{"t": 0,
/// "x": 5, "z": 5}, {"t": 4, "x": 9, "z": 5}]}], "start": {"x": 3, "z": 3, "heading_deg": 90}, "goal": {...},
/// "walkers": [{"start": {...}, "goal": {...}}], "constraints": {"gait": "walk", "min_speed_m_s": 0.8,
/// "max_speed_m_s": 1.6, "latest_arrival_s": 20, "areas": [{"x": 4, "z": 4, "width": 2, "depth": 2, "kind":
/// "avoid"}]}, "radius": 0.4, "seed": 1}. version, name, moving, heading_deg, walkers, constraints and each
/// of its members, radius and seed may be missing; repeat is "loop" when it is. Unknown members of the outer
/// object are kept for writeSceneJson; a known one that is missing, of the wrong type or out of range is
/// kSceneValue, and names the member, what was found and what was expected. Text that is no JSON is
/// kSceneSyntax with line and column; so is text that is not UTF-8 (a byte-order mark may stand before it).
/// `name` becomes the error's file. Members that are not known, or that an object has more than once, go to
/// `notes` where it is not null, as warnings with topic kScene, line and column (sceneNotes); those there
/// before stay.
Result<Scene> readSceneJson(std::string_view text, std::string_view name = "scene",
                            Warnings* notes = nullptr);

/// The scene as JSON text, numbers as short as they can be. Reading it back gives the same scene, bit for bit
/// but for headings that no number of degrees gives exactly: these come back within one unit in the last
/// place. unknownMembers that are no JSON object are left out.
std::string writeSceneJson(const Scene& scene);

/// What is wrong with a scene's values, as readSceneJson says it; nothing when the scene is usable.
Result<void> checkScene(const Scene& scene);

}  // namespace stridegraph
