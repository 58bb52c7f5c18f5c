#include "commands.h"

using namespace stridegraph::tools;

int main(int argc, char** argv) {
  CLI::App program{
      "Motion capture clips become a motion graph; through a drawn room, a captured human walks.\n"
      "Exit status: 0 done, 1 refused for a reason that the report holds, 2 wrong use or unreadable input.",
      "stridegraph"};
  program.require_subcommand(1);
  program.set_version_flag("--version", STRIDEGRAPH_VERSION);
  Job job;
  addBuildCommand(program, job);
  addInfoCommand(program, job);
  addPlanCommand(program, job);
  addGaitCommand(program, job);
  addFiguresCommand(program, job);
  addBenchCommand(program, job);
  return runProgram(program, argc, argv, job);
}
