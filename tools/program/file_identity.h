#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace stridegraph::tools {

/// Which file a path means, whatever way it is written: links, relative forms and hard links of a file are
/// one and the same, and so are names that differ in case where the folder takes them for the same. A file
/// that is not there yet is told by its folder and name.
class FileIdentity {
 public:
  explicit FileIdentity(const std::string& path);

  /// False for pipes and devices, which may be given more than once, and for what cannot be looked at.
  bool isSameAs(const FileIdentity& other) const;

 private:
  struct Key {
    dev_t device = 0;
    ino_t number = 0;  ///< Of the file, or of the folder when the file is not there.
    std::string name;  ///< Empty when the file is there.
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> key_;
};

/// The path that links lead to, step by step; the path itself where it is no link. Works for links to files
/// that are not there.
std::string resolveLinks(const std::string& path);

/// The folder that a path's last name lies in: "." for a bare name.
std::string folderOf(const std::string& path);

/// A path and what it is for, as messages call it: "--scene", "the clip".
struct NamedPath {
  std::string role;
  std::string path;
};

/// Refuses, with kFile, an output that is one of the inputs or another output, one without a name, one that
/// is a folder, and one whose folder is not there. Nothing is written. Empty paths of outputs that were not
/// asked for are the caller's to leave out.
Result<void> checkOutputs(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs);

}  // namespace stridegraph::tools
