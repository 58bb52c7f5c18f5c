#pragma once

#include <string>

#include "base/error.h"

namespace stridegraph::tools {

/// Prints each note to standard error as "note: file:line:column: message"; nothing when `isQuiet`.
void printNotes(const Warnings& notes, bool isQuiet);

/// Says of a file from an earlier run that a run which failed left it as it was: "walk.bvh: is the file of
/// before, nothing was written to it". Nothing where there is no such file.
void noteFileOfBefore(const std::string& path, const std::string& isNot, Warnings& notes);

}  // namespace stridegraph::tools
