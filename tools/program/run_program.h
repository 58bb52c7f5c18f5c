#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace stridegraph::tools {

/// How a program ends.
enum ExitCode : int {
  kDone = 0,      ///< Everything asked for is done.
  kRefused = 1,   ///< Understood, but there is no such walk or library; the report says why.
  kWrongUse = 2,  ///< Wrong arguments, or input that cannot be read.
};

/// What a program does once its arguments are understood; gives the exit code.
using Job = std::function<int()>;

/// Parses the arguments and runs the job that the parser's callbacks leave in `job`. Whatever goes wrong ends
/// in a sentence on standard error and kWrongUse: arguments that are not understood (the nearest command or
/// option is suggested), anything thrown, output that cannot be written. Only a broken promise within the
/// program aborts. Without any arguments prints the help and gives kWrongUse.
int runProgram(CLI::App& program, int argc, char** argv, Job& job);

/// Prints "NAME COMMAND: sentence" to standard error.
void complain(const std::string& who, const std::string& sentence);

}  // namespace stridegraph::tools
