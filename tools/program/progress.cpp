#include "program/progress.h"

#include <unistd.h>

#include "wall_clock.h"

namespace stridegraph::tools {
namespace {

ProgressStyle styleOf(bool isQuiet) {
  if (isQuiet) return ProgressStyle::kNone;
  return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::kTerminal : ProgressStyle::kLines;
}

void write(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(const std::string& what, bool isQuiet)
    : text_(what, styleOf(isQuiet)), began_(millisecondsNow()) {}

Progress::~Progress() {
  write(text_.clearing());
}

void Progress::at(double share) {
  if (const auto text = text_.at(share, milliseconds())) write(*text);
}

double Progress::milliseconds() const {
  return millisecondsNow() - began_;
}

}  // namespace stridegraph::tools
