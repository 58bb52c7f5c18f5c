#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "base/error.h"
#include "walk/plan.h"

namespace stridegraph::tools {

/// What `stridegraph plan` is asked.
struct PlanArguments {
  std::string graphPath;
  std::string scenePath;
  std::string walkPath;
  std::string reportPath;
  bool isQuiet = false;
  PlanOptions options;
  /// Which of the options that not every plan heeds were given.
  bool asksForPlanner = false;
};

/// Adds the options of the command; all are in `arguments` once they are parsed.
void addPlanOptions(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments);

/// Options that make no difference beside the others, a note each.
Warnings uselessOptions(const PlanArguments& arguments);

}  // namespace stridegraph::tools
