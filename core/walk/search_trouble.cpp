#include "walk/search_trouble.h"

#include <fmt/format.h>

#include <algorithm>

namespace stridegraph {

namespace {

/// A length as it is told, to tenths of a metre, never as -0.0.
double tenths(double metres) {
  return std::round(10.0 * metres) / 10.0 + 0.0;
}

/// "(4.0, 5.5)"
std::string told(const Vec2& place) {
  return fmt::format("({:.1f}, {:.1f})", tenths(place.x()), tenths(place.y()));
}

}  // namespace

void SearchTrouble::add(const SearchTrouble& other) {
  begun = begun || other.begun;
  blocked = other.blocked;
  blockedFrame = other.blockedFrame;
  if (other.metresLeft < metresLeft) {
    metresLeft = other.metresLeft;
    nearest = other.nearest;
  }
  atTraffic += other.atTraffic;
  tooLate += other.tooLate;
  soonestSeconds = std::min(soonestSeconds, other.soonestSeconds);
}

std::string nearestThing(const FloorPlan& plan, const Vec2& point) {
  double least =
      std::min({point.x(), point.y(), plan.widthMetres() - point.x(), plan.depthMetres() - point.y()});
  std::size_t thing = plan.boxes().size();
  for (std::size_t i = 0; i < plan.boxes().size(); ++i) {
    const double metres = signedDistance(plan.boxes()[i], point);
    if (metres >= least) continue;
    least = metres;
    thing = i;
  }
  if (thing == plan.boxes().size()) return "the room's wall";
  const Vec2& centre = plan.obstacles()[thing].centre;
  return fmt::format("obstacle {} at {}", thing + 1, told(centre));
}

std::string nearestReached(const SearchTrouble& trouble, const FloorPlan& plan) {
  if (!trouble.hasReached()) return "no way from the start comes to a place where it could go on";
  return fmt::format("the nearest to the goal came to {}, {:.1f} m before it, beside {}",
                     told(trouble.nearest), tenths(trouble.metresLeft), nearestThing(plan, trouble.nearest));
}

std::string explainNoMotion(const SearchTrouble& trouble, const FloorPlan& plan,
                            const SearchBeginning& beginning) {
  const bool knowsSoonest = std::isfinite(trouble.soonestSeconds);
  if (!trouble.begun && trouble.tooLate > 0 && knowsSoonest)
    return fmt::format(
        "the goal is too far to be there in the time asked for: the fastest walk that these clips can make "
        "would take about {:.1f} s",
        trouble.soonestSeconds);
  if (!trouble.begun) {
    const bool still = !plan.isFree(trouble.blocked);
    return fmt::format("every first step from the start at {} touches {}: give it more room, or turn it",
                       told(beginning.start), still ? nearestThing(plan, trouble.blocked) : beginning.mover);
  }
  std::string text = "no walk that these clips can make leads through: " + nearestReached(trouble, plan);
  if (trouble.tooLate > 0 && knowsSoonest)
    text +=
        fmt::format("; other ways would have come too late, after {:.1f} s or more", trouble.soonestSeconds);
  if (trouble.atTraffic > 0) text += "; others met something that moves";
  return text + "; more clips, tighter turns or a mirrored library would help";
}

}  // namespace stridegraph
