#include "walk/cost_to_go.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridegraph {
namespace {

/// Turns of the way ahead are looked at in strides of this length.
constexpr double kStrideMetres = 0.4;

/// A turn from one stride to the next below this is the grid's noise.
constexpr double kNoiseRadians = 0.03;

/// Nearer to the goal than this the way's direction says nothing of turns to come.
constexpr double kNearGoalMetres = 1.2;

/// What turning on the way costs beyond the way itself. Measured as what makes estimates in rooms with many
/// corners as good as in open ones, for captured and synthesised libraries alike (0.2 to 0.3).
constexpr double kTurnMetresPerRadian = 0.2;

}  // namespace

CostToGo::CostToGo(const SearchTables& tables, const DistanceField& field, const Vec2& roomSize)
    : tables_(tables),
      field_(field),
      pitchMetres_(2.0 * field.cellMetres()),
      columns_(static_cast<std::size_t>(roomSize.x() / pitchMetres_) + 2),
      rows_(static_cast<std::size_t>(roomSize.y() / pitchMetres_) + 2),
      posts_(columns_ * rows_) {}

std::size_t CostToGo::nearestPost(const Vec2& point) const {
  const auto column = static_cast<std::size_t>(std::max(point.x() / pitchMetres_ + 0.5, 0.0));
  const auto row = static_cast<std::size_t>(std::max(point.y() / pitchMetres_ + 0.5, 0.0));
  return std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
}

Vec2 CostToGo::placeOf(std::size_t post) const {
  return Vec2(static_cast<double>(post % columns_) * pitchMetres_,
              static_cast<double>(post / columns_) * pitchMetres_);
}

void CostToGo::look(std::size_t index) {
  Post& post = posts_[index];
  const DistanceField::Sample at = field_.at(placeOf(index));
  post.state = std::isfinite(at.metres) ? Post::kOpen : Post::kClosed;
  post.sin = static_cast<float>(at.direction.x());
  post.cos = static_cast<float>(at.direction.y());
}

/// The cell one stride along the way; itself where there is none nearer to the goal.
std::size_t CostToGo::onwardFrom(std::size_t index) const {
  const Post& post = posts_[index];
  const Vec2 centre = placeOf(index);
  const double here = field_.metresToGoal(centre);
  if (here < kNearGoalMetres) return index;
  const std::size_t ahead = nearestPost(centre + kStrideMetres * Vec2(post.sin, post.cos));
  if (ahead != index && field_.metresToGoal(placeOf(ahead)) < here) return ahead;
  // Beside walls the direction may lead into them: then the neighbour nearest to the goal.
  std::size_t best = index;
  double least = here;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dx = -1; dx <= 1; ++dx) {
      const std::size_t next = nearestPost(centre + pitchMetres_ * Vec2(dx, dz));
      const double metres = field_.metresToGoal(placeOf(next));
      if (metres >= least) continue;
      least = metres;
      best = next;
    }
  }
  return best;
}

const CostToGo::Post& CostToGo::known(std::size_t index) {
  trail_.clear();
  std::size_t at = index;
  while (true) {
    if (posts_[at].state == Post::kUnknown) look(at);
    if (posts_[at].state != Post::kOpen) break;
    trail_.push_back(at);
    const std::size_t next = onwardFrom(at);
    if (next == at) break;
    at = next;
  }
  for (; !trail_.empty(); trail_.pop_back()) {
    Post& post = posts_[trail_.back()];
    const Post& next = posts_[at];
    post.state = Post::kKnown;
    if (next.state == Post::kKnown && at != trail_.back()) {
      const double cosine = std::clamp(double{post.sin} * next.sin + double{post.cos} * next.cos, -1.0, 1.0);
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const double turned = turnFraction(Heading{sine, cosine}) * 2.0 * std::numbers::pi;
      post.turnedRadians = next.turnedRadians + static_cast<float>(std::max(0.0, turned - kNoiseRadians));
    }
    at = trail_.back();
  }
  return posts_[index];
}

double CostToGo::turnedAhead(const Vec2& point) {
  const double x = point.x() / pitchMetres_;
  const double z = point.y() / pitchMetres_;
  const auto column = static_cast<std::size_t>(x);
  const auto row = static_cast<std::size_t>(z);
  const double alongX = x - static_cast<double>(column);
  const double alongZ = z - static_cast<double>(row);
  double sum = 0.0;
  double weight = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t right = k & 1U;
    const std::size_t up = k >> 1U;
    const Post& post = known((row + up) * columns_ + column + right);
    if (post.state != Post::kKnown) continue;
    const double share = (right == 1 ? alongX : 1.0 - alongX) * (up == 1 ? alongZ : 1.0 - alongZ);
    sum += share * double{post.turnedRadians};
    weight += share;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

double CostToGo::metres(std::uint32_t node, const FloorTransform& placement) {
  const DistanceField::Sample at = field_.at(placement.translation);
  if (!std::isfinite(at.metres)) return at.metres;
  const double straight =
      tables_.steering.costPerMetre() * at.metres + kTurnMetresPerRadian * turnedAhead(placement.translation);
  if (at.direction.isZero()) return straight;
  const Heading direction = Heading{at.direction.x(), at.direction.y()} - placement.heading;
  return straight + tables_.steering.extraMetres(node, direction);
}

}  // namespace stridegraph
