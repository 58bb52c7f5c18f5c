#include "motion/bvh_motion.h"

#include <fmt/format.h>

#include <utility>

#include "motion/bvh_frame_time.h"
#include "motion/bvh_limits.h"
#include "motion/bvh_rows.h"

namespace stridegraph {
namespace {

/// What is wrong with a number of frames, and what is expected; empty when nothing is.
std::string faultInFrames(std::size_t frames, const BvhHierarchy& hierarchy) {
  const std::size_t joints = hierarchy.joints.size();
  if (frames == 0) return "found 0 frames, expected at least 1";
  if (frames > kMostBvhFrames)
    return fmt::format("found {} frames, expected at most {}", frames, kMostBvhFrames);
  if (frames > kMostBvhRotations / joints)
    return fmt::format("found {} frames of {} joints, expected at most {} rotations in all", frames, joints,
                       kMostBvhRotations);
  if (frames > kMostBvhNumbers / hierarchy.columns)
    return fmt::format("found {} frames of {} numbers, expected at most {} numbers in all", frames,
                       hierarchy.columns, kMostBvhNumbers);
  return {};
}

Result<std::size_t> parseFrameCount(BvhScanner& scanner, const BvhHierarchy& hierarchy) {
  if (!scanner.takeWord("FRAMES") || !scanner.takeSymbol(':')) return scanner.expected("\"Frames:\"");
  const std::size_t offset = scanner.offset();
  Result<std::size_t> declared = scanner.takeCount("the number of frames");
  if (!declared) return declared;
  if (std::string fault = faultInFrames(*declared, hierarchy); !fault.empty())
    return fail(ErrorCode::kBvhValue, std::move(fault), scanner.placeOf(offset));
  return declared;
}

}  // namespace

Result<BvhMotion> parseBvhMotion(BvhScanner& scanner, const BvhHierarchy& hierarchy) {
  if (!scanner.takeWord("MOTION")) return scanner.expected("MOTION");
  const Result<std::size_t> declared = parseFrameCount(scanner, hierarchy);
  if (!declared) return tl::unexpected(declared.error());
  if (!scanner.takeWord("FRAME") || !scanner.takeWord("TIME") || !scanner.takeSymbol(':'))
    return scanner.expected("\"Frame Time:\"");
  Result<BvhFrameTime> time = parseBvhFrameTime(scanner);
  if (!time) return fail(std::move(time));
  Result<BvhRows> rows = parseBvhRows(scanner, {hierarchy.columns, hierarchy.joints.size(), *declared});
  if (!rows) return fail(std::move(rows));

  BvhMotion motion;
  motion.framesPerSecond = time->framesPerSecond;
  motion.columns = hierarchy.columns;
  motion.frameCount = rows->values.size() / hierarchy.columns;
  motion.values = std::move(rows->values);
  if (time->warning) motion.warnings.push_back(*std::move(time->warning));
  for (Warning& warning : rows->warnings) motion.warnings.push_back(std::move(warning));
  return motion;
}

}  // namespace stridegraph
