#pragma once

#include <sys/resource.h>

#include <string>
#include <vector>

namespace stridegraph::tools {

/// How a program ended, and what it wrote.
struct Ended {
  int exitCode = -1;  ///< -1 when a signal ended it.
  int signal = 0;     ///< SIGALRM when it ran for longer than kMostSeconds.
  std::string out;
  std::string err;

  /// "exit 2, stderr: ..." for messages of tests.
  std::string describe() const;
};

/// For how long a run may take, even under the sanitizers of a busy machine.
inline constexpr unsigned kMostSeconds = 300;

/// How a run differs from the usual one.
struct RunOptions {
  std::string program = "";              ///< Empty: stridegraph.
  std::string outPath = "";              ///< Standard output goes there instead.
  std::string folder = "";               ///< Where it runs; empty: here.
  bool closesOutput = false;             ///< Without standard output.
  rlim_t mostFileBytes = RLIM_INFINITY;  ///< Larger files cannot be written, as on a full disk.
};

/// Runs a program with arguments of any bytes and without standard input.
Ended runProgramWith(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace stridegraph::tools
