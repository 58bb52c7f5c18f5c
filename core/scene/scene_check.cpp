#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scene/scene_json.h"
#include "scene/scene_limits.h"

namespace stridegraph {

namespace {

using Checked = Result<void>;

tl::unexpected<Error> wrong(const std::string& member, double found, std::string_view expected) {
  return fail(ErrorCode::kSceneValue, fmt::format("{}: found {}, expected {}", member, found, expected));
}

Checked checkFinite(const std::string& member, double value) {
  if (!std::isfinite(value)) return wrong(member, value, "a finite number");
  return {};
}

Checked checkWithin(const std::string& member, double value, double low, double high) {
  if (!(value >= low && value <= high))
    return wrong(member, value, fmt::format("a number from {} to {}", low, high));
  return {};
}

/// On both sides of 0.
Checked checkMagnitude(const std::string& member, double value, double most) {
  if (Checked finite = checkFinite(member, value); !finite) return finite;
  return checkWithin(member, value, -most, most);
}

Checked checkPoint(const std::string& member, const Vec2& point) {
  if (Checked x = checkMagnitude(member + ".x", point.x(), kFarthestMetres); !x) return x;
  return checkMagnitude(member + ".z", point.y(), kFarthestMetres);
}

Checked checkSide(const std::string& member, double metres) {
  if (!(metres > 0.0 && std::isfinite(metres))) return wrong(member, metres, "a number above 0");
  return checkWithin(member, metres, 0.0, kFarthestMetres);
}

Checked checkSize(const std::string& member, const Vec2& size) {
  if (Checked width = checkSide(member + ".width", size.x()); !width) return width;
  return checkSide(member + ".depth", size.y());
}

Checked checkPlacement(const std::string& member, const Placement& placement) {
  if (Checked position = checkPoint(member, placement.position); !position) return position;
  if (!placement.heading) return {};
  return checkMagnitude(member + ".heading_deg", placement.heading->degrees(), kMostHeadingDegrees);
}

Checked checkCount(const std::string& member, std::size_t count, std::size_t most) {
  if (count <= most) return {};
  return fail(ErrorCode::kSceneValue,
              fmt::format("{}: found {} elements, expected at most {}", member, count, most));
}

Checked checkMoving(const std::string& member, const MovingObstacle& moving) {
  if (Checked size = checkSize(member, moving.size); !size) return size;
  if (moving.track.empty()) {
    return fail(ErrorCode::kSceneValue,
                fmt::format("{}.track: found 0 elements, expected at least 1", member));
  }
  if (Checked count = checkCount(member + ".track", moving.track.size(), kMostTrackPoints); !count)
    return count;
  for (std::size_t i = 0; i < moving.track.size(); ++i) {
    const std::string place = fmt::format("{}.track[{}]", member, i);
    const TrackPoint& point = moving.track[i];
    if (Checked time = checkMagnitude(place + ".t", point.seconds, kMostTrackSeconds); !time) return time;
    if (i > 0 && !(point.seconds > moving.track[i - 1].seconds)) {
      return wrong(place + ".t", point.seconds, fmt::format("a time above {}", moving.track[i - 1].seconds));
    }
    if (Checked position = checkPoint(place, point.position); !position) return position;
  }
  return {};
}

Checked checkRectangle(const std::string& member, const Rectangle& rectangle) {
  if (Checked centre = checkPoint(member, rectangle.centre); !centre) return centre;
  return checkSize(member, rectangle.size);
}

Checked checkSpeeds(const WalkConstraints& constraints) {
  const std::optional<double>& least = constraints.minSpeedMetresPerSecond;
  const std::optional<double>& most = constraints.maxSpeedMetresPerSecond;
  if (most) {
    if (Checked speed = checkWithin("constraints.max_speed_m_s", *most, 0.0, kMostMetresPerSecond); !speed) {
      return speed;
    }
  }
  if (!least) return {};
  return checkWithin("constraints.min_speed_m_s", *least, 0.0, most.value_or(kMostMetresPerSecond));
}

Checked checkConstraints(const WalkConstraints& constraints) {
  if (Checked speeds = checkSpeeds(constraints); !speeds) return speeds;
  if (const std::optional<double>& arrival = constraints.latestArrivalSeconds;
      arrival && !(*arrival > 0.0 && *arrival <= kMostArrivalSeconds)) {
    return wrong("constraints.latest_arrival_s", *arrival,
                 fmt::format("a number above 0 and at most {}", kMostArrivalSeconds));
  }
  if (Checked count = checkCount("constraints.areas", constraints.areas.size(), kMostAreas); !count) {
    return count;
  }
  for (std::size_t i = 0; i < constraints.areas.size(); ++i) {
    const std::string place = fmt::format("constraints.areas[{}]", i);
    if (Checked area = checkRectangle(place, constraints.areas[i].rectangle); !area) return area;
  }
  return {};
}

Checked checkWalkers(const Scene& scene) {
  if (Checked start = checkPlacement("start", scene.start); !start) return start;
  if (Checked goal = checkPlacement("goal", scene.goal); !goal) return goal;
  if (Checked count = checkCount("walkers", scene.walkers.size(), kMostWalkers); !count) return count;
  for (std::size_t i = 0; i < scene.walkers.size(); ++i) {
    const std::string place = fmt::format("walkers[{}]", i);
    if (Checked start = checkPlacement(place + ".start", scene.walkers[i].start); !start) return start;
    if (Checked goal = checkPlacement(place + ".goal", scene.walkers[i].goal); !goal) return goal;
  }
  return {};
}

}  // namespace

Result<void> checkScene(const Scene& scene) {
  if (Checked width = checkWithin("width", scene.widthMetres, kLeastRoomMetres, kMostRoomMetres); !width) {
    return width;
  }
  if (Checked depth = checkWithin("depth", scene.depthMetres, kLeastRoomMetres, kMostRoomMetres); !depth) {
    return depth;
  }
  if (Checked radius = checkWithin("radius", scene.radiusMetres, kLeastRadiusMetres, kMostRadiusMetres);
      !radius) {
    return radius;
  }
  if (Checked count = checkCount("obstacles", scene.obstacles.size(), kMostObstacles); !count) return count;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    if (Checked obstacle = checkRectangle(fmt::format("obstacles[{}]", i), scene.obstacles[i]); !obstacle) {
      return obstacle;
    }
  }
  if (Checked count = checkCount("moving", scene.moving.size(), kMostObstacles); !count) return count;
  for (std::size_t i = 0; i < scene.moving.size(); ++i) {
    if (Checked moving = checkMoving(fmt::format("moving[{}]", i), scene.moving[i]); !moving) return moving;
  }
  if (Checked walkers = checkWalkers(scene); !walkers) return walkers;
  return checkConstraints(scene.constraints);
}

}  // namespace stridegraph
