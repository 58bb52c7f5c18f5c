#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace stridegraph::tools {

/// How a program ends.
enum ExitCode : int {
  kDone = 0,      ///< Everything asked for is done.
  kRefused = 1,   ///< Understood, but there is no such walk or library; the report says why.
  kWrongUse = 2,  ///< Wrong arguments, or input that cannot be read.
};

/// Each adds its sub-command to the program and leaves the exit code in `exitCode` when it ran.
void addBuildCommand(CLI::App& program, int& exitCode);
void addInfoCommand(CLI::App& program, int& exitCode);
void addPlanCommand(CLI::App& program, int& exitCode);
void addGaitCommand(CLI::App& program, int& exitCode);
void addFiguresCommand(CLI::App& program, int& exitCode);
void addBenchCommand(CLI::App& program, int& exitCode);

}  // namespace stridegraph::tools
