#include "program_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "program/descriptor.h"
#include "program/files.h"

namespace stridegraph::tools {
namespace {

/// A file without a name that takes what a program writes.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {}
  ~Capture() {
    if (file_ != nullptr) std::fclose(file_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int descriptor() const { return ::fileno(file_); }
  std::string text() const {
    std::string text;
    std::array<char, 4096> block{};
    ::lseek(descriptor(), 0, SEEK_SET);
    for (ssize_t count = 0; (count = ::read(descriptor(), block.data(), block.size())) > 0;)
      text.append(block.data(), static_cast<std::size_t>(count));
    return text;
  }

 private:
  std::FILE* file_;
};

void redirect(int from, int to) {
  if (from >= 0) ::dup2(from, to);
}

/// The child's part; never comes back.
[[noreturn]] void become(const std::vector<std::string>& arguments, const RunOptions& options, int out,
                         int err) {
  if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(127);
  redirect(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  redirect(options.outPath.empty() ? out : ::open(options.outPath.c_str(), O_WRONLY), STDOUT_FILENO);
  redirect(err, STDERR_FILENO);
  if (options.closesOutput) ::close(STDOUT_FILENO);
  if (options.mostFileBytes != RLIM_INFINITY) {
    const rlimit limit{options.mostFileBytes, options.mostFileBytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
  }
  ::alarm(kMostSeconds);
  std::string program = options.program.empty() ? STRIDEGRAPH_PROGRAM : options.program;
  std::vector<std::string> texts = arguments;
  std::vector<char*> pointers = {program.data()};
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  ::_exit(127);
}

}  // namespace

std::string Ended::describe() const {
  return fmt::format("exit {}, signal {}\nout: {}\nerr: {}", exitCode, signal, out, err);
}

Ended runProgramWith(const std::vector<std::string>& arguments, const RunOptions& options) {
  const Capture out;
  const Capture err;
  const pid_t child = ::fork();
  if (child == 0) become(arguments, options, out.descriptor(), err.descriptor());
  Ended ended;
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return ended;
  if (WIFEXITED(status)) ended.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  ended.out = out.text();
  ended.err = err.text();
  return ended;
}

}  // namespace stridegraph::tools
