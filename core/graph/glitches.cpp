#include "graph/glitches.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/rotation.h"

namespace stridegraph {
namespace {

/// The second largest of the turns around `frame`, so that a single wrong frame, which makes two jumps, is
/// not its own excuse. With one neighbour that one; without any 0.
double usualTurnAround(const std::vector<double>& turns, std::size_t frame) {
  constexpr std::size_t kReach = 3;
  double largest = 0.0;
  double second = 0.0;
  std::size_t count = 0;
  for (std::size_t f = frame - std::min(frame, kReach); f <= frame + kReach && f < turns.size(); ++f) {
    if (f == frame) continue;
    second = std::max(second, std::min(largest, turns[f]));
    largest = std::max(largest, turns[f]);
    ++count;
  }
  return count == 1 ? largest : second;
}

Clip partOf(const Clip& clip, std::size_t first, std::size_t end) {
  Clip part{.name = first == 0 ? clip.name : fmt::format("{} from frame {}", clip.name, first),
            .framesPerSecond = clip.framesPerSecond,
            .jointCount = clip.jointCount,
            .rootPositions = {},
            .rotations = {}};
  for (std::size_t f = first; f < end; ++f) part.append(clip.pose(f));
  return part;
}

}  // namespace

std::vector<Glitch> findGlitches(const Clip& clip, const GlitchParams& params) {
  if (clip.frameCount() < 3) return {};
  const std::size_t steps = clip.frameCount() - 1;
  std::vector<Glitch> farthest(steps);
  for (std::size_t j = 0; j < clip.jointCount; ++j) {
    std::vector<double> turns(steps);
    for (std::size_t f = 0; f < steps; ++f)
      turns[f] = angleBetween(clip.pose(f).rotations[j], clip.pose(f + 1).rotations[j]).radians();
    for (std::size_t f = 0; f < steps; ++f) {
      const bool isJump =
          turns[f] > params.leastTurn.radians() && turns[f] > params.factor * usualTurnAround(turns, f);
      if (isJump && turns[f] > farthest[f].turn.radians())
        farthest[f] = {f, JointIndex(j), Angle::radians(turns[f])};
    }
  }
  std::erase_if(farthest, [](const Glitch& glitch) { return glitch.turn.radians() == 0.0; });
  return farthest;
}

std::vector<Clip> cutAtGlitches(const Clip& clip, const std::vector<Glitch>& glitches) {
  std::vector<Clip> pieces;
  std::size_t first = 0;
  const auto addPiece = [&](std::size_t end) {
    if (end - first >= 2 || glitches.empty()) pieces.push_back(partOf(clip, first, end));
    first = end;
  };
  for (const Glitch& glitch : glitches) addPiece(glitch.frame + 1);
  addPiece(clip.frameCount());
  // A lost beginning is said in the warning, not in the name.
  if (!pieces.empty()) pieces.front().name = clip.name;
  return pieces;
}

}  // namespace stridegraph
