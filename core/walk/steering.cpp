#include "walk/steering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stridegraph {
namespace {

/// Sweeps at most; twenty are usual.
constexpr int kSweeps = 60;

/// Settled when a sweep changes the cost per metre by less than this.
constexpr double kSettled = 1e-4;

/// What walks cost per metre at first.
constexpr double kLikelyCostPerMetre = 1.1;

/// Progress of a typical walk that one sweep follows, metres: turns the drift of the values into an error of
/// the cost per metre. Too much is slow, too little swings.
constexpr double kSweepProgressMetres = 12.0;

/// What comes after each way counts for a little less when the values are found, since rooms bend walks after
/// some metres: a walker need not break into a jog for what that would save far away.
constexpr float kOnwardShare = 0.97F;
constexpr int kSweepsOnward = 20;

/// A way as the iteration sees it.
struct Step {
  std::uint32_t to = 0;
  float cost = 0.0F;
  float right = 0.0F, ahead = 0.0F;  ///< Displacement, metres.
  std::uint32_t sectors = 0;         ///< By which directions turn, seen from the way's end: whole sectors
  float share = 0.0F;                ///< and a part of one more.
};

double sectorsOf(const Heading& heading) {
  return turnFraction(heading) * SteeringTable::kSectors;
}

}  // namespace

class SteeringIteration {
 public:
  SteeringIteration(const SearchGraph& graph, const SteeringTable::MoreCost& costOf, SteeringTable& table)
      : table_(table), nodes_(graph.nodeCount()) {
    for (std::uint32_t s = 0; s < kSectors; ++s) {
      const Heading heading = Heading::fromAngle(Angle::degrees(360.0 * s / kSectors));
      sines_[s] = static_cast<float>(heading.sin);
      cosines_[s] = static_cast<float>(heading.cos);
    }
    for (std::uint32_t node = 0; node < nodes_; ++node) {
      firstStep_.push_back(static_cast<std::uint32_t>(steps_.size()));
      for (const SearchEdge& edge : graph.edgesFrom(node)) {
        if (edge.to != SearchEdge::kNone) steps_.push_back(stepAlong(edge, costOf(edge)));
      }
    }
    firstStep_.push_back(static_cast<std::uint32_t>(steps_.size()));
    table_.values_.assign(nodes_ * kRow, 0.0F);
  }

  void run() {
    table_.costPerMetre_ = kLikelyCostPerMetre;
    for (int i = 0; i < kSweeps; ++i) {
      const double change = sweep() / kSweepProgressMetres;
      table_.costPerMetre_ += change;
      if (std::abs(change) < kSettled) break;
    }
    onwardShare_ = kOnwardShare;
    for (int i = 0; i < kSweepsOnward; ++i) {
      subtractLeast();
      sweep();
    }
    subtractLeast();
    layOutForReading();
  }

 private:
  static constexpr std::uint32_t kSectors = SteeringTable::kSectors;
  static constexpr std::uint32_t kRow = SteeringTable::kRow;

  static Step stepAlong(const SearchEdge& edge, double cost) {
    const double turned = sectorsOf(Heading{} - edge.end.heading);
    const auto whole = static_cast<std::uint32_t>(turned);
    return {edge.to,
            static_cast<float>(cost),
            static_cast<float>(edge.end.translation.x()),
            static_cast<float>(edge.end.translation.y()),
            whole % kSectors,
            static_cast<float>(turned - static_cast<double>(whole))};
  }

  float leastValue() const { return *std::min_element(table_.values_.begin(), table_.values_.end()); }

  void subtractLeast() {
    const float least = leastValue();
    for (float& value : table_.values_) value -= least;
  }

  /// From even sectors, which ways turn by, to even parts of quarterTurns(), which is cheaper to tell of a
  /// direction.
  void layOutForReading() {
    std::array<float, kRow> even;
    for (std::size_t node = 0; node < nodes_; ++node) {
      float* const row = table_.values_.data() + node * kRow;
      std::copy(row, row + kRow, even.begin());
      for (std::uint32_t k = 0; k <= kSectors; ++k) {
        const double sectors =
            sectorsOf(atQuarterTurns(k % kSectors * SteeringTable::kQuarterTurnsPerSector));
        const auto whole = std::min(static_cast<std::uint32_t>(sectors), kSectors - 1);
        const auto share = static_cast<float>(sectors - whole);
        row[k] = even[whole] + share * (even[whole + 1] - even[whole]);
      }
    }
  }

  /// The direction, not of unit length, of which quarterTurns() are told.
  static Heading atQuarterTurns(double quarters) {
    const double sine = quarters < 1.0 ? quarters : quarters < 3.0 ? 2.0 - quarters : quarters - 4.0;
    return {sine, (quarters < 1.0 || quarters > 3.0 ? 1.0 : -1.0) * (1.0 - std::abs(sine))};
  }

  /// One sweep over all nodes; returns by how much the smallest value fell or rose. Clips run from node to
  /// node, so from the last node to the first what is known of a clip's end comes to its beginning at once.
  double sweep() {
    const auto perMetre = static_cast<float>(table_.costPerMetre_);
    const double before = double{leastValue()};
    std::array<float, kSectors> best;
    for (std::size_t node = nodes_; node-- > 0;) {
      best.fill(std::numeric_limits<float>::max());
      for (std::uint32_t s = firstStep_[node]; s < firstStep_[node + 1]; ++s)
        relax(steps_[s], perMetre, best);
      float* const row = table_.values_.data() + node * kRow;
      std::copy(best.begin(), best.end(), row);
      std::copy(best.begin(), best.end(), row + kSectors);
      row[2 * kSectors] = row[0];
    }
    return double{leastValue()} - before;
  }

  void relax(const Step& step, float perMetre, std::array<float, kSectors>& best) const {
    const float* const values = table_.values_.data() + step.to * kRow + step.sectors;
    for (std::uint32_t k = 0; k < kSectors; ++k) {
      const float progress = step.right * sines_[k] + step.ahead * cosines_[k];
      const float onward = values[k] + step.share * (values[k + 1] - values[k]);
      best[k] = std::min(best[k], step.cost - perMetre * progress + onwardShare_ * onward);
    }
  }

  SteeringTable& table_;
  std::size_t nodes_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> firstStep_;
  std::array<float, kSectors> sines_{}, cosines_{};
  float onwardShare_ = 1.0F;
};

SteeringTable::SteeringTable(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond,
                             const MoreCost& more) {
  const auto costOf = [&](const SearchEdge& way) {
    return cost.ofWay(way, framesPerSecond) + (more ? more(way) : 0.0);
  };
  SteeringIteration(graph, costOf, *this).run();
}

double SteeringTable::extraMetres(std::uint32_t node, const Heading& direction) const {
  const double parts = quarterTurns(direction) / kQuarterTurnsPerSector;
  const auto whole = std::min(static_cast<std::uint32_t>(parts), kSectors - 1);
  const float* const values = values_.data() + node * kRow + whole;
  return double{values[0]} + (parts - whole) * (double{values[1]} - double{values[0]});
}

}  // namespace stridegraph
