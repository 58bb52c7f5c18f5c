#pragma once

#include <string>

#include "base/error.h"
#include "graph/build_report.h"
#include "graph/build_trials.h"
#include "graph/library.h"

namespace stridegraph {

/// A graph that holds less than this share of the frames is hardly a library: more is tried to say what
/// helps.
inline constexpr double kTinyShare = 0.1;
/// What would make one of it is to bring in this share.
inline constexpr double kUsefulShare = 1.0 / 3.0;

/// Why no walk along the clips of a library could go on for ever, and what would help, in figures that were
/// tried out.
std::string adviceOnNoGraph(const MotionLibrary& library, const BuildReport& report,
                            const TrialFindings& findings);

/// What walks along a library's graph cannot do, and what would help: the graph holds next to nothing of the
/// clips, nothing in it travels, or nothing stands, or walks curve to one side only. All have the topic
/// kGraph and no place, since they are about the library as a whole.
Warnings limitsOf(const MotionLibrary& library, const BuildReport& report, const TrialFindings& findings);

}  // namespace stridegraph
