#include <cstdio>

#include "commands.h"

using namespace stridegraph::tools;

int main(int argc, char** argv) {
  CLI::App program{
      "Motion capture clips become a motion graph; through a drawn room, a captured human walks."};
  program.require_subcommand(1);
  program.set_version_flag("--version", STRIDEGRAPH_VERSION);
  int exitCode = kDone;
  addBuildCommand(program, exitCode);
  addInfoCommand(program, exitCode);
  addPlanCommand(program, exitCode);
  addGaitCommand(program, exitCode);
  addFiguresCommand(program, exitCode);
  addBenchCommand(program, exitCode);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kWrongUse;
  }
  return exitCode;
}
