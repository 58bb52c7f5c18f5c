#pragma once

#include <csignal>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace stridegraph::tools {

/// Files that are written together, each whole or not at all: their content goes into temporary files beside
/// them, and only when all of it is on the disk do these take the files' names. A file that is a link stays
/// one, and what it leads to is replaced; permissions of a file that is there stay as they are. Pipes,
/// devices and open descriptors (/dev/stdout, /dev/fd/3) are written to directly. From the first file to the
/// end of its life signals that end the program (SIGINT, SIGTERM, SIGHUP, SIGQUIT) wait, so that no temporary
/// file stays behind.
class OutputFiles {
 public:
  OutputFiles();
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Prepares a file; kFile when that fails, for instance on a full disk. The file of before is still there.
  Result<void> add(const std::string& path, std::string_view content);
  Result<void> add(const std::string& path, std::span<const std::uint8_t> bytes);
  /// Gives all files their names. After an error some may have theirs.
  Result<void> commit();

 private:
  struct Pending {
    std::string path;     ///< As it was asked for.
    std::string target;   ///< What is replaced, or written to.
    std::string part;     ///< The temporary file; empty for what is written to directly.
    std::string content;  ///< Of these.
  };
  Result<void> addPart(Pending pending, std::string_view content);
  void holdSignals();

  std::vector<Pending> pending_;
  std::optional<sigset_t> signalsBefore_;
};

/// One file by itself.
Result<void> writeFile(const std::string& path, std::string_view content);
Result<void> writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

/// Whether text for people would be mixed up with an output, because that is standard output itself.
bool isStandardOutput(const std::string& path);

/// Whether a regular file is there, such as the result of a run before.
bool isFileThere(const std::string& path);

/// Makes the folder, and those that it lies in, where they are not there; kFile where that fails.
Result<void> makeFolder(const std::string& folder);

}  // namespace stridegraph::tools
