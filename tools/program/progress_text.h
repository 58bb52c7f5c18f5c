#pragma once

#include <optional>
#include <string>

namespace stridegraph::tools {

/// How progress is shown: one line that is written over on a terminal, a line now and then elsewhere.
enum class ProgressStyle { kNone, kTerminal, kLines };

/// What to write of a piece of work under way, and when. Knows no clock: times are handed in, milliseconds
/// since the work began, never falling.
class ProgressText {
 public:
  ProgressText(std::string what, ProgressStyle style);

  /// What to write now that `share` (0..1) is done; nothing when it is too soon. On a terminal from half a
  /// second on, ten times a second; as lines every ten seconds.
  std::optional<std::string> at(double share, double milliseconds);

  /// What clears the line on a terminal; empty when there is none.
  std::string clearing();

 private:
  std::string what_;
  ProgressStyle style_;
  double nextMilliseconds_;
  bool isShown_ = false;
};

/// "about 20 s left", judged by the pace so far; empty while that is too uncertain: in the first two seconds
/// or the first fiftieth of the work.
std::string timeLeft(double share, double milliseconds);

}  // namespace stridegraph::tools
