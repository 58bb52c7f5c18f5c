#include "notes.h"

#include <fmt/format.h>

#include <cstdio>

#include "program/output_files.h"
#include "program/shown_text.h"

namespace stridegraph::tools {

void printNotes(const Warnings& notes, bool isQuiet) {
  if (isQuiet) return;
  for (const Warning& note : notes) printLine(stderr, fmt::format("note: {}", describe(note)));
}

void noteFileOfBefore(const std::string& path, const std::string& isNot, Warnings& notes) {
  if (path.empty() || !isFileThere(path)) return;
  notes.push_back(
      {fmt::format("is still the file of before, not {}", isNot), {shownText(path)}, WarningTopic::kOther});
}

}  // namespace stridegraph::tools
