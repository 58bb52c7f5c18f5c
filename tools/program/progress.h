#pragma once

#include <cstdio>
#include <string>

#include "program/progress_text.h"

namespace stridegraph::tools {

/// Shows on standard error how far a piece of work is; clears its line at the end of its life. Nothing is
/// shown when `isQuiet`.
class Progress {
 public:
  Progress(const std::string& what, bool isQuiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work is done, 0..1.
  void at(double share);
  /// Milliseconds since the work began.
  double milliseconds() const;

 private:
  ProgressText text_;
  double began_;
};

}  // namespace stridegraph::tools
