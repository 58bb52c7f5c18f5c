#pragma once

#include <memory>
#include <vector>

#include "scene/scene.h"
#include "walk/search_graph.h"
#include "walk/steering.h"

namespace stridegraph {

/// What a library's walks cost where scenes ask for a pace: a steering table for each wish, made when it is
/// first asked for (some milliseconds) and kept, since all walkers of a scene ask for the same, and a scene
/// that is edited asks for it again and again. So questions are not const, and come from one thread at a
/// time; answers do not depend on their order. Borrows the graph.
class PaceTables {
 public:
  /// Tables are kept for so many wishes; the one that was made first gives way.
  static constexpr std::size_t kMost = 8;

  PaceTables(const SearchGraph& graph, double framesPerSecond)
      : graph_(graph), framesPerSecond_(framesPerSecond) {}

  /// The table of who is asked for a gait or a speed.
  std::shared_ptr<const SteeringTable> steering(const WalkConstraints& wishes);

 private:
  struct Kept {
    WalkConstraints wishes;  ///< Gait and speeds only.
    std::shared_ptr<const SteeringTable> table;
  };

  const SearchGraph& graph_;
  double framesPerSecond_;
  std::vector<Kept> kept_;
};

}  // namespace stridegraph
