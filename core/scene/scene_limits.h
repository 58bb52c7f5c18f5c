#pragma once

#include <cstddef>

namespace stridegraph {

/// What a scene may hold. Wide enough for any room worth walking in, narrow enough that no scene can ask for
/// more memory or time than a page has.
inline constexpr double kLeastRoomMetres = 1.0;
inline constexpr double kMostRoomMetres = 1000.0;
/// Of places and sizes, whatever the sign: a thousand rooms away, where arithmetic is still exact.
inline constexpr double kFarthestMetres = 1e6;
/// Of times along tracks, whatever the sign: eleven days.
inline constexpr double kFarthestSeconds = 1e6;
inline constexpr double kLeastRadiusMetres = 0.05;
inline constexpr double kMostRadiusMetres = 5.0;
inline constexpr std::size_t kMostObstacles = 10'000;
inline constexpr std::size_t kMostTrackPoints = 10'000;
inline constexpr std::size_t kMostWalkers = 100;
inline constexpr std::size_t kMostAreas = 1000;
inline constexpr double kMostMetresPerSecond = 10.0;
inline constexpr double kMostArrivalSeconds = 3600.0;

}  // namespace stridegraph
