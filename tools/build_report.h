#pragma once

#include <string>

#include "graph/library_builder.h"

namespace stridegraph::tools {

/// What the report of a build tells beside what the builder found.
struct BuildOutcome {
  const MotionLibrary* library = nullptr;  ///< None when building failed.
  const Error* error = nullptr;            ///< Why.
  Warnings notes;                          ///< What the program found odd, beside the report's warnings.
};

/// The report as a JSON file. "warnings" are lines, "notes" the same in parts (notesJson).
std::string buildReportText(const BuildReport& report, const BuildOutcome& outcome);

}  // namespace stridegraph::tools
