#pragma once

#include "walk/arrivals.h"
#include "walk/search_graph.h"
#include "walk/steering.h"

namespace stridegraph {

/// All that the motion searches know of a library before they see a room. Built once; immutable; does not
/// move, since its parts refer to one another.
struct SearchTables {
  explicit SearchTables(const MotionLibrary& library) : SearchTables(library, capturedLimits(library)) {}
  SearchTables(const MotionLibrary& library, const MotionLimits& limits);
  SearchTables(const SearchTables&) = delete;
  SearchTables& operator=(const SearchTables&) = delete;

  SearchGraph graph;
  ArrivalTable arrivals;
  SteeringTable steering;
};

}  // namespace stridegraph
