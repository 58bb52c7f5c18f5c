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

/// Posts around a place whose directions cancel out, as around the goal, name none.
constexpr double kLeastDirection = 0.05;

/// What turning on the way costs beyond the way itself. Measured as what makes estimates in rooms with many
/// corners as good as in open ones, for captured and synthesised libraries alike (0.15 to 0.2).
constexpr double kTurnMetresPerRadian = 0.15;

}  // namespace

CostToGo::CostToGo(const SteeringTable& steering, const DistanceField& field, const Vec2& roomSize,
                   const PaceTable* pace)
    : steering_(steering),
      pace_(pace),
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
  post.prospect = {static_cast<float>(at.metres), static_cast<float>(at.direction.x()),
                   static_cast<float>(at.direction.y()), 0.0F};
}

/// The cell one stride along the way; itself where there is none nearer to the goal.
std::size_t CostToGo::onwardFrom(std::size_t index) const {
  const Prospect& post = posts_[index].prospect;
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
  if (posts_[index].state >= Post::kKnown) return posts_[index];
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
    post.state = Post::kKnown;
    if (posts_[at].state == Post::kKnown && at != trail_.back()) {
      const Prospect& next = posts_[at].prospect;
      const double cosine =
          std::clamp(double{post.prospect.sin} * next.sin + double{post.prospect.cos} * next.cos, -1.0, 1.0);
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const double turned = turnFraction(Heading{sine, cosine}) * 2.0 * std::numbers::pi;
      post.prospect.turnedRadians =
          next.turnedRadians + static_cast<float>(std::max(0.0, turned - kNoiseRadians));
    }
    at = trail_.back();
  }
  return posts_[index];
}

/// Bilinear between the posts around that are known; nothing where none is, or outside of the room.
std::optional<CostToGo::Prospect> CostToGo::prospectAt(const Vec2& point) {
  const double x = point.x() / pitchMetres_;
  const double z = point.y() / pitchMetres_;
  if (!(x >= 0.0 && z >= 0.0)) return std::nullopt;
  const auto column = static_cast<std::size_t>(x);
  const auto row = static_cast<std::size_t>(z);
  if (column + 1 >= columns_ || row + 1 >= rows_) return std::nullopt;
  const auto alongX = static_cast<float>(x - static_cast<double>(column));
  const auto alongZ = static_cast<float>(z - static_cast<double>(row));
  Prospect sum;
  float weight = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t right = k & 1U;
    const std::size_t up = k >> 1U;
    const Post& post = known((row + up) * columns_ + column + right);
    if (post.state != Post::kKnown) continue;
    const float share = (right == 1 ? alongX : 1.0F - alongX) * (up == 1 ? alongZ : 1.0F - alongZ);
    sum.metres += share * post.prospect.metres;
    sum.sin += share * post.prospect.sin;
    sum.cos += share * post.prospect.cos;
    sum.turnedRadians += share * post.prospect.turnedRadians;
    weight += share;
  }
  if (weight <= 0.0F) return std::nullopt;
  sum.metres /= weight;
  sum.turnedRadians /= weight;
  return sum;
}

double CostToGo::metres(std::uint32_t node, const FloorTransform& placement) {
  const double estimated = estimate(node, placement);
  if (trust_ == 0.0 || marks_.empty()) return estimated;
  return estimated + trust_ * learnedMetres(field_.metresToGoal(placement.translation));
}

/// Linear between marks, of which there are some.
double CostToGo::learnedMetres(double metresToGoal) const {
  const auto above =
      std::lower_bound(marks_.begin(), marks_.end(), metresToGoal,
                       [](const Mark& mark, double metres) { return mark.metresToGoal < metres; });
  if (above == marks_.end()) return marks_.back().extraMetres;
  if (above == marks_.begin()) return above->extraMetres;
  const Mark& below = *(above - 1);
  const double share = (metresToGoal - below.metresToGoal) / (above->metresToGoal - below.metresToGoal);
  return below.extraMetres + share * (above->extraMetres - below.extraMetres);
}

double CostToGo::estimate(std::uint32_t node, const FloorTransform& placement) {
  const std::optional<Prospect> at = prospectAt(placement.translation);
  // In a gap that no post stands in, the bare way has to do.
  if (!at) return field_.metresToGoal(placement.translation);
  const double usual = along(steering_, node, placement.heading, *at);
  if (pace_ == nullptr) return usual;
  const double kept = along(pace_->steering, node, placement.heading, *at);
  const double unhurried = usual + pace_->unhurriedPerMetre * double{at->metres};
  if (!comesToStand_) return std::min(kept, unhurried);
  return std::max(std::min(kept + pace_->stopMetres, unhurried + pace_->unhurriedStopMetres),
                  pace_->standMetres[node]);
}

/// What is left from a place where a table holds all along.
double CostToGo::along(const SteeringTable& steering, std::uint32_t node, const Heading& facing,
                       const Prospect& at) {
  const double straight =
      steering.costPerMetre() * double{at.metres} + kTurnMetresPerRadian * double{at.turnedRadians};
  const double sin = double{at.sin};
  const double cos = double{at.cos};
  if (sin * sin + cos * cos < kLeastDirection * kLeastDirection) return straight;
  // As a difference of headings, but not brought to unit length, which the table does not need.
  return straight + steering.extraMetres(
                        node, {sin * facing.cos - cos * facing.sin, cos * facing.cos + sin * facing.sin});
}

}  // namespace stridegraph
