#pragma once

#include "program_run.h"
#include "test_folder.h"

namespace stridegraph::tools {

/// A folder with a small library (lib.sgraph), one of its clips (walk.bvh) and scenes (room.json,
/// closed.json, three.json with three walkers), made once for all tests of a program.
class CommandFolder : public TestFolder {
 protected:
  void SetUp() override;

  /// Runs stridegraph in the folder.
  Ended run(const std::vector<std::string>& arguments, RunOptions options = {}) const;
  /// The same, and that it ends with this exit code and sound text.
  Ended expectExit(int code, const std::vector<std::string>& arguments, RunOptions options = {}) const;
  /// Writes the room with one piece of its text replaced.
  void writeRoom(const std::string& name, const std::string& from, const std::string& to) const;
};

}  // namespace stridegraph::tools
