#pragma once

#include "program/run_program.h"

namespace stridegraph::tools {

/// Each adds its sub-command to the program; once that is understood it leaves what there is to do in `job`.
void addBuildCommand(CLI::App& program, Job& job);
void addInfoCommand(CLI::App& program, Job& job);
void addPlanCommand(CLI::App& program, Job& job);
void addGaitCommand(CLI::App& program, Job& job);
void addFiguresCommand(CLI::App& program, Job& job);
void addBenchCommand(CLI::App& program, Job& job);

}  // namespace stridegraph::tools
