#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program/file_identity.h"
#include "program/output_files.h"
#include "walk/plan.h"

namespace stridegraph::tools {

/// Where walks go: to WALK.bvh of the first walker and WALK_2.bvh, WALK_3.bvh ... of the others, or all
/// together to WALK.glb.
class WalkFiles {
 public:
  /// `path` ends in .bvh or .glb.
  explicit WalkFiles(std::string path) : path_(std::move(path)) {}

  /// What is wrong with a path as one of walks; empty when nothing is.
  static std::string faultIn(const std::string& path);

  bool holdsAll() const { return path_.ends_with(".glb"); }
  /// Of the walker with that index.
  std::string pathOf(std::size_t walker) const;
  /// The files of so many walkers, with the option as their role.
  std::vector<NamedPath> outputs(std::size_t walkers) const;

  /// Adds the walks of all who arrive.
  Result<void> addTo(OutputFiles& files, const MotionLibrary& library,
                     const std::vector<const Plan*>& plans) const;
  /// Notes on files of an earlier run that are not part of these plans: of walkers who did not arrive, and of
  /// further ones than there are.
  void noteOld(const std::vector<const Plan*>& plans, Warnings& notes) const;

 private:
  std::string path_;
};

/// The plan of the first walker, then those of the others.
std::vector<const Plan*> allOf(const Plan& plan);

bool hasArrived(const Plan& plan);

}  // namespace stridegraph::tools
