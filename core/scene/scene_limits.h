#pragma once

#include <cstddef>

namespace stridegraph {

/// What a scene may hold. Wide enough for any room worth walking in, narrow enough that no scene can ask for
/// more memory or time than a page has.
inline constexpr double kLeastRoomMetres = 1.0;
inline constexpr double kMostRoomMetres = 1000.0;
inline constexpr double kLeastRadiusMetres = 0.05;
inline constexpr double kMostRadiusMetres = 5.0;
inline constexpr std::size_t kMostObstacles = 10'000;
inline constexpr std::size_t kMostTrackPoints = 10'000;
inline constexpr std::size_t kMostWalkers = 100;
inline constexpr std::size_t kMostAreas = 1000;
inline constexpr double kMostMetresPerSecond = 10.0;
inline constexpr double kMostArrivalSeconds = 3600.0;
inline constexpr double kFarthestMetres = 1e6;    ///< Coordinates, from the room's corner, and sides.
inline constexpr double kMostTrackSeconds = 1e6;  ///< Before or after the walk's beginning.
inline constexpr double kMostHeadingDegrees = 1e6;

/// What the text of a scene may hold: bytes, levels of nesting, members of one object.
inline constexpr std::size_t kMostSceneBytes = std::size_t{16} << 20U;
inline constexpr std::size_t kMostJsonLevels = 64;
inline constexpr std::size_t kMostJsonMembers = 256;
/// Names of odd members that a reader lists one by one.
inline constexpr std::size_t kMostSceneNotes = 50;

}  // namespace stridegraph
