#pragma once

#include <memory>
#include <vector>

#include "scene/scene.h"
#include "walk/search_graph.h"
#include "walk/steering.h"

namespace stridegraph {

/// What a library's walks cost where a scene asks for a pace, metres.
struct PaceTable {
  SteeringTable steering;
  /// From each decision node what coming to a stand takes, wherever that leads.
  std::vector<double> standMetres;
  /// What coming to a stand takes at least beyond the metres gone by, at the cost that they have in a walk
  /// that keeps to the pace,
  double stopMetres = 0.0;
  /// and in one that does not,
  double unhurriedStopMetres = 0.0;
  /// for which a metre costs so much more than usual.
  double unhurriedPerMetre = 0.0;
};

/// How soon a library's walks can be somewhere: estimates that leave no time for turns and blends to spare.
struct Hurry {
  double secondsPerMetre = 0.0;      ///< Of the fastest walk that goes on and on.
  std::vector<double> goingSeconds;  ///< From each decision node what getting to that pace takes beside,
  double stopSeconds = 0.0;          ///< and what coming to a stand from it takes.

  /// From a node to a place so far away, 0 or more, to stop there or not.
  double secondsTo(std::uint32_t node, double metres, bool standing) const;
};

/// The tables of all paces that scenes ask for: made when they are first asked for (some milliseconds) and
/// kept, since all walkers of a scene ask for the same, and a scene that is edited asks for it again and
/// again. So questions are not const, and come from one thread at a time; answers do not depend on their
/// order. Borrows the search tables' graph and usual steering.
class PaceTables {
 public:
  /// Tables are kept for so many wishes; the one that was made first gives way.
  static constexpr std::size_t kMost = 8;

  PaceTables(const SearchGraph& graph, const SteeringTable& usual, double framesPerSecond)
      : graph_(graph), usual_(usual), framesPerSecond_(framesPerSecond) {}

  /// The table of who is asked for a gait or a speed.
  std::shared_ptr<const PaceTable> of(const WalkConstraints& wishes);
  /// How soon its walks can be somewhere.
  std::shared_ptr<const Hurry> hurry();

 private:
  struct Kept {
    WalkConstraints wishes;  ///< Gait and speeds only.
    std::shared_ptr<const PaceTable> table;
  };

  std::shared_ptr<const PaceTable> make(const WalkConstraints& pace) const;
  std::shared_ptr<const Hurry> makeHurry() const;

  const SearchGraph& graph_;
  const SteeringTable& usual_;
  double framesPerSecond_;
  std::vector<Kept> kept_;
  std::shared_ptr<const Hurry> hurry_;
};

}  // namespace stridegraph
