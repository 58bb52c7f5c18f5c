#include "bench/random_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/random.h"
#include "path/connectivity.h"
#include "path/floor_plan.h"
#include "path/sampled_path.h"

namespace stridegraph::bench {
namespace {

constexpr double kRasterMetres = 0.1;
constexpr int kEndTries = 30;
constexpr double kThinning = 0.98;

/// To the centimetre, so that a scene's text stays short.
double rounded(double metres) {
  return std::round(100.0 * metres) / 100.0;
}

/// The points of a room's floor that rectangles cover.
class CoverRaster {
 public:
  CoverRaster(double widthMetres, double depthMetres)
      : columns_(static_cast<std::size_t>(widthMetres / kRasterMetres)),
        rows_(static_cast<std::size_t>(depthMetres / kRasterMetres)),
        covered_(columns_ * rows_, false) {}

  void cover(const Rectangle& rectangle) {
    const Box box = boxOf(rectangle);
    const std::size_t rowEnd = pointsBelow(box.maxZ, rows_);
    const std::size_t columnEnd = pointsBelow(box.maxX, columns_);
    for (std::size_t row = pointsBelow(box.minZ, rows_); row < rowEnd; ++row) {
      for (std::size_t column = pointsBelow(box.minX, columns_); column < columnEnd; ++column) {
        const std::size_t point = row * columns_ + column;
        count_ += covered_[point] ? 0 : 1;
        covered_[point] = true;
      }
    }
  }

  double share() const { return static_cast<double>(count_) / static_cast<double>(columns_ * rows_); }

 private:
  /// How many of the points at 0.05, 0.15, ... m lie below a coordinate.
  static std::size_t pointsBelow(double metres, std::size_t most) {
    const double points = std::ceil(metres / kRasterMetres - 0.5);
    return static_cast<std::size_t>(std::clamp(points, 0.0, static_cast<double>(most)));
  }

  std::size_t columns_;
  std::size_t rows_;
  std::vector<bool> covered_;
  std::size_t count_ = 0;
};

Rectangle drawRectangle(const Scene& room, const RandomRoomParams& params, Random& random) {
  Vec2 size;
  if (params.mostWallMetres > 0.0 && random.below(3) == 0) {
    size.x() = rounded(random.uniform(2.0, params.mostWallMetres));
    size.y() = rounded(random.uniform(0.2, 0.4));
    if (random.below(2) == 0) std::swap(size.x(), size.y());
  } else {
    size.x() = rounded(random.uniform(0.5, params.mostBlockMetres));
    size.y() = rounded(random.uniform(0.5, params.mostBlockMetres));
  }
  const double x = rounded(random.uniform(0.0, room.widthMetres));
  return {{x, rounded(random.uniform(0.0, room.depthMetres))}, size};
}

void furnish(Scene& room, double clutter, const RandomRoomParams& params, Random& random) {
  room.obstacles.clear();
  CoverRaster raster(room.widthMetres, room.depthMetres);
  const auto isEnough = [&] {
    return params.rectangles ? room.obstacles.size() >= *params.rectangles : raster.share() >= clutter;
  };
  while (!isEnough()) {
    room.obstacles.push_back(drawRectangle(room, params, random));
    raster.cover(room.obstacles.back());
  }
}

/// Start and goal far apart with a way between them; false where a few tries find none.
bool placeEnds(Scene& room, const RandomRoomParams& params, Random& random) {
  const FloorPlan plan(room, params.radiusMetres + params.spareMetres);
  const double apart = 0.5 * std::hypot(room.widthMetres, room.depthMetres);
  for (int i = 0; i < kEndTries; ++i) {
    const std::optional<Vec2> start = sampleFree(plan, random);
    const std::optional<Vec2> goal = sampleFree(plan, random);
    if (!start || !goal || (*goal - *start).norm() < apart || !isConnected(plan, *start, *goal)) continue;
    room.start.position = *start;
    room.goal.position = *goal;
    return true;
  }
  return false;
}

}  // namespace

Scene randomRoom(std::uint64_t seed, std::uint64_t number, const RandomRoomParams& params) {
  // One step of the generator keeps neighbouring numbers apart.
  Random random(Random(seed).bits() + number);
  random = Random(random.bits());
  Scene room;
  room.name = fmt::format("random room {} of {}", number, seed);
  room.widthMetres = rounded(random.uniform(params.leastSideMetres, params.mostSideMetres));
  room.depthMetres = rounded(random.uniform(params.leastSideMetres, params.mostSideMetres));
  room.radiusMetres = params.radiusMetres;
  const double heading = std::floor(random.uniform(-180.0, 180.0));
  room.start.heading = Angle::degrees(heading);
  double clutter = random.uniform(params.leastClutter, params.mostClutter);
  for (;;) {
    furnish(room, clutter, params, random);
    if (placeEnds(room, params, random)) return room;
    clutter = std::max(params.leastClutter, kThinning * clutter);
  }
}

double clutterOf(const Scene& scene) {
  CoverRaster raster(scene.widthMetres, scene.depthMetres);
  for (const Rectangle& rectangle : scene.obstacles) raster.cover(rectangle);
  return raster.share();
}

}  // namespace stridegraph::bench
