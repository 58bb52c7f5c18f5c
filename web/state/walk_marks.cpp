#include "state/walk_marks.h"

#include <fmt/format.h>

#include <algorithm>

namespace stridegraph {

namespace {

/// Captured clips themselves go that far beyond what they nearly always do.
constexpr double kRatioOfCaptures = 1.6;

WalkMark ratioMark(const char* name, const char* what, const JointRatio& worst) {
  return {worst.frame, name, fmt::format("{:.2f}\xc3\x97", worst.ratio),
          fmt::format("Frame {}: joint {} {} {:.2f} times as hard as the clips do at most", worst.frame,
                      worst.joint, what, worst.ratio),
          worst.ratio > kRatioOfCaptures};
}

}  // namespace

std::vector<WalkMark> walkMarks(const PlanReport& report) {
  if (report.status != PlanStatus::kArrived) return {};
  std::vector<WalkMark> marks = {ratioMark("Joint speed", "turns", report.jointSpeed),
                                 ratioMark("Joint acceleration", "is driven", report.jointAcceleration)};
  const auto dearest = std::max_element(
      report.seams.begin(), report.seams.end(),
      [](const WalkSeam& a, const WalkSeam& b) { return a.distanceMetres < b.distanceMetres; });
  if (dearest != report.seams.end()) {
    const double centimetres = 100.0 * dearest->distanceMetres;
    marks.push_back({dearest->frame, "Widest seam", fmt::format("{:.1f} cm", centimetres),
                     fmt::format("Frame {}: a transition between poses that are {:.1f} cm apart",
                                 dearest->frame, centimetres),
                     false});
  }
  return marks;
}

}  // namespace stridegraph
