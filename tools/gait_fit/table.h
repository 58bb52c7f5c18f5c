#pragma once

#include <string>

#include "gait_fit/side_laws.h"

namespace stridegraph::gait_fit {

/// The fit as core's table holds it, rounded to its unit. Fails with kInvalidArgument when a coefficient is
/// too large for it.
Result<GaitTable> tableOf(const Series& series, const SideLaws& laws, double reach);

/// The mean pose of the frames in which the root is slower than 0.12 m/s, over all clips, made symmetrical.
/// Fails with kInvalidArgument when nobody stands still.
Result<StandingTable> measureStanding(std::span<const Clip> clips);

/// What is written out.
struct FittedTables {
  GaitTable walk;
  GaitTable jog;
  StandingTable standing;
  std::vector<std::string> origin;  ///< Sentences on source and terms.
};

/// core/motion/gait_table.cpp.
std::string toSource(const FittedTables& tables);

/// The same numbers, named, as JSON.
std::string toJson(const FittedTables& tables);

}  // namespace stridegraph::gait_fit
