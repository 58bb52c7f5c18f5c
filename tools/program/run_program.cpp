#include "program/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <sstream>

#include "program/name_list.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

/// Standard streams that are closed would give their numbers to files: text would be printed into these.
void openStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF) ::open("/dev/null", O_RDWR);
  }
}

std::vector<std::string> commandsOf(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// "stridegraph plan"
std::string nameOf(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program.get_name() : program.get_name() + " " + chosen.front()->get_name();
}

const CLI::App& chosenOf(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

/// The names of all options, with their dashes.
std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options({})) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// What is wrong with arguments that nothing takes; empty when all are taken.
std::string faultInExtras(const CLI::App& program) {
  const std::vector<std::string> extras = program.remaining(true);
  if (extras.empty()) return {};
  const std::string found = extras.front().substr(0, extras.front().find('='));
  const bool isOption = found.size() > 1 && found.front() == '-';
  if (!isOption && program.get_subcommands().empty() && !commandsOf(program).empty())
    return fmt::format("found {}, expected {}{}", quotedText(found), listOf(commandsOf(program)),
                       suggestionFor(found, commandsOf(program)));
  if (isOption)
    return fmt::format("found {}, which is no option{}", quotedText(found),
                       suggestionFor(found, optionsOf(chosenOf(program))));
  return fmt::format("found {}, expected no further argument", quotedText(extras.front()));
}

/// Prints what parsing ended with; the exit code.
int finishParsing(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    std::ostringstream out;
    program.exit(error, out, out);
    print(stdout, out.str());
    return kDone;
  }
  const std::string extras = faultInExtras(program);
  complain(nameOf(program), extras.empty() ? shownText(error.what()) : extras);
  printLine(stderr, fmt::format("{} --help lists what there is", nameOf(program)));
  return kWrongUse;
}

int parseAndRun(CLI::App& program, int argc, char** argv, Job& job) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return finishParsing(program, error);
  }
  return job ? job() : kDone;
}

}  // namespace

void complain(const std::string& who, const std::string& sentence) {
  printLine(stderr, fmt::format("{}: {}", who, sentence));
}

int runProgram(CLI::App& program, int argc, char** argv, Job& job) {
  openStandardStreams();
  // A reader that has gone is an error of writing like any other.
  std::signal(SIGPIPE, SIG_IGN);
  if (argc < 2) {
    print(stdout, program.help());
    finishOutput();
    return kWrongUse;
  }
  int code = kWrongUse;
  try {
    code = parseAndRun(program, argc, argv, job);
  } catch (const std::bad_alloc&) {
    complain(nameOf(program), "there is not enough memory for this");
    code = kWrongUse;
  } catch (const std::exception& error) {
    complain(nameOf(program), shownText(error.what()));
    code = kWrongUse;
  }
  if (finishOutput()) return code;
  complain(nameOf(program), fmt::format("standard output cannot be written: {}", std::strerror(errno)));
  return kWrongUse;
}

}  // namespace stridegraph::tools
