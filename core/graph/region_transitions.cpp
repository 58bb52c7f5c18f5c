#include "graph/region_transitions.h"

namespace stridegraph {

std::vector<FrameTransition> transitionsOf(std::span<const AlikeRegion> regions) {
  std::vector<FrameTransition> transitions;
  transitions.reserve(2 * regions.size());
  for (const AlikeRegion& region : regions) {
    const std::uint32_t rowSpan = region.rowSpan;
    const std::uint32_t columnSpan = region.columnSpan;
    const std::uint32_t frames = (rowSpan + columnSpan) / 2;
    const FrameIndex rowEnd(std::size_t{region.row.value} + rowSpan);
    const FrameIndex columnEnd(std::size_t{region.column.value} + columnSpan);
    transitions.push_back({region.row, columnEnd, rowSpan, columnSpan, frames, region.distanceMetres});
    transitions.push_back({region.column, rowEnd, columnSpan, rowSpan, frames, region.distanceMetres});
  }
  return transitions;
}

}  // namespace stridegraph
