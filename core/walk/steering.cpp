#include "walk/steering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stridegraph {
namespace {

constexpr int kSweeps = 120;

/// Share of the new value in each sweep: cycles of ways of one length would swing otherwise.
constexpr float kDamping = 0.7F;

/// Progress of a typical way, metres: turns the drift of the values into an error of the cost per metre.
constexpr double kTypicalProgressMetres = 0.5;

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
  SteeringIteration(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond,
                    SteeringTable& table)
      : table_(table), nodes_(graph.nodeCount()) {
    for (std::uint32_t s = 0; s < kSectors; ++s) {
      const Heading heading = Heading::fromAngle(Angle::degrees(360.0 * s / kSectors));
      sines_[s] = static_cast<float>(heading.sin);
      cosines_[s] = static_cast<float>(heading.cos);
    }
    for (std::uint32_t node = 0; node < nodes_; ++node) {
      firstStep_.push_back(static_cast<std::uint32_t>(steps_.size()));
      for (const SearchEdge& edge : graph.edgesFrom(node)) {
        if (edge.to != SearchEdge::kNone) steps_.push_back(stepAlong(edge, cost, framesPerSecond));
      }
    }
    firstStep_.push_back(static_cast<std::uint32_t>(steps_.size()));
    table_.values_.assign(nodes_ * kRow, 0.0F);
  }

  void run() {
    std::vector<float> next(table_.values_.size(), 0.0F);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const double drift = this->sweep(next);
      table_.values_.swap(next);
      table_.costPerMetre_ += drift / kTypicalProgressMetres;
    }
    const float least = *std::min_element(table_.values_.begin(), table_.values_.end());
    for (float& value : table_.values_) value -= least;
  }

 private:
  static constexpr std::uint32_t kSectors = SteeringTable::kSectors;
  static constexpr std::uint32_t kRow = SteeringTable::kRow;

  static Step stepAlong(const SearchEdge& edge, const WalkCost& cost, double framesPerSecond) {
    const double turned = sectorsOf(Heading{} - edge.end.heading);
    const auto whole = static_cast<std::uint32_t>(turned);
    return {edge.to,
            static_cast<float>(cost.ofGoing(edge, framesPerSecond) + cost.ofTransitions(edge)),
            static_cast<float>(edge.end.translation.x()),
            static_cast<float>(edge.end.translation.y()),
            whole % kSectors,
            static_cast<float>(turned - static_cast<double>(whole))};
  }

  /// One sweep over all nodes; returns by how much the smallest value fell or rose.
  double sweep(std::vector<float>& next) const {
    const auto perMetre = static_cast<float>(table_.costPerMetre_);
    std::array<float, kSectors> best;
    for (std::size_t node = 0; node < nodes_; ++node) {
      best.fill(std::numeric_limits<float>::max());
      for (std::uint32_t s = firstStep_[node]; s < firstStep_[node + 1]; ++s)
        relax(steps_[s], perMetre, best);
      const float* const old = table_.values_.data() + node * kRow;
      float* const row = next.data() + node * kRow;
      for (std::uint32_t k = 0; k < kSectors; ++k) {
        row[k] = old[k] + kDamping * (best[k] - old[k]);
        row[k + kSectors] = row[k];
      }
      row[2 * kSectors] = row[0];
    }
    const float before = *std::min_element(table_.values_.begin(), table_.values_.end());
    return static_cast<double>(*std::min_element(next.begin(), next.end()) - before);
  }

  void relax(const Step& step, float perMetre, std::array<float, kSectors>& best) const {
    const float* const values = table_.values_.data() + step.to * kRow + step.sectors;
    for (std::uint32_t k = 0; k < kSectors; ++k) {
      const float progress = step.right * sines_[k] + step.ahead * cosines_[k];
      const float onward = values[k] + step.share * (values[k + 1] - values[k]);
      best[k] = std::min(best[k], step.cost - perMetre * progress + onward);
    }
  }

  SteeringTable& table_;
  std::size_t nodes_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> firstStep_;
  std::array<float, kSectors> sines_{}, cosines_{};
};

SteeringTable::SteeringTable(const SearchGraph& graph, const WalkCost& cost, double framesPerSecond) {
  SteeringIteration(graph, cost, framesPerSecond, *this).run();
}

double SteeringTable::extraMetres(std::uint32_t node, const Heading& direction) const {
  const double sectors = sectorsOf(direction);
  const auto whole = std::min(static_cast<std::uint32_t>(sectors), kSectors - 1);
  const float* const values = values_.data() + node * kRow + whole;
  return double{values[0]} + (sectors - whole) * (double{values[1]} - double{values[0]});
}

}  // namespace stridegraph
