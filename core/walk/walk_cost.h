#pragma once

#include "walk/search_graph.h"

namespace stridegraph {

/// What a walk costs, in metres: its length, and what else we would walk further to avoid.
struct WalkCost {
  double perSecond = 0.05;        ///< Standing about is not free.
  double perRadian = 0.05;        ///< Of bending a way: as captured is best.
  double perStrain = 3.0;         ///< Of driving joints harder than usual (frameStrains).
  double perTransition = 0.28;    ///< Else three quarters of all frames would be blends.
  double perTransitionMetre = 5;  ///< Times the transition's distance: good blends are preferred.
  double seedVariation = 0.02;    ///< A way costs up to this share more, by seed: other seeds, other walks.
  double movingStart = 1.5;       ///< For a walk that begins in motion where it could from a stand.

  /// Of going a way, before seeds vary it.
  double ofGoing(const SearchEdge& edge, double framesPerSecond) const {
    return edge.lengthMetres + perRadian * edge.bendRadians + perStrain * edge.strain +
           perSecond * static_cast<double>(edge.sampleCount) / framesPerSecond;
  }
  /// Of the blends on it.
  double ofTransitions(const SearchEdge& edge) const {
    return perTransition * edge.transitions + perTransitionMetre * edge.transitionDistanceMetres;
  }
  /// Of both.
  double ofWay(const SearchEdge& edge, double framesPerSecond) const {
    return ofGoing(edge, framesPerSecond) + ofTransitions(edge);
  }
};

}  // namespace stridegraph
