#include "bench/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/map_tables.h"
#include "bench/summary.h"
#include "bench/table_text.h"

namespace stridegraph::bench {
namespace {

std::string randomTable(const std::vector<BenchRun>& runs) {
  const std::vector<Summary> summaries = summariesOfSet(runs, kRandomSet);
  if (summaries.empty()) return {};
  Table table({"library", "place", "search", "sound", "ms: median", "90 %", "99 %", "worst", "refused: worst",
               "length / shortest: median", "90 %", "worst", "transitions / s", "blended",
               "expansions: median", "99 %"});
  for (const Summary& row : summaries) {
    const double percentSound = 100.0 * static_cast<double>(row.sound) / static_cast<double>(row.runs);
    table.add({row.library, placeTitle(row.place), row.method,
               fmt::format("{} of {}: {:.1f} %", row.sound, row.runs, percentSound),
               figure(row.totalMilliseconds.median), figure(row.totalMilliseconds.p90),
               figure(row.totalMilliseconds.p99), figure(row.totalMilliseconds.worst),
               row.arrived == row.runs ? "-" : figure(row.refusedMilliseconds.worst),
               fmt::format("{:.3f}", row.lengthRatio.median), fmt::format("{:.3f}", row.lengthRatio.p90),
               fmt::format("{:.2f}", row.lengthRatio.worst), figure(row.transitionsPerSecond.median),
               percent(row.blendedShare.median), fmt::format("{:.0f}", row.expansions.median),
               fmt::format("{:.0f}", row.expansions.p99)});
  }
  return section("Random rooms",
                 "Seeded rooms of 12 to 40 m a side with 5 to 25 % of the floor under blocks and walls; "
                 "somewhere between start and goal is a way for a disc 0.25 m wider than the body's.",
                 table);
}

/// A line for each library and reason, with the rooms; what failed natively is not said again of other
/// places.
std::string failuresList(const std::vector<BenchRun>& runs) {
  std::map<std::string, Cells> roomsOf;
  for (const BenchRun& run : runs) {
    if (run.set != kRandomSet || run.place != "native" || isSound(run)) continue;
    const std::string why = run.explanation.empty() ? "" : fmt::format(" ({})", run.explanation);
    roomsOf[fmt::format("{}: {}{}", run.library, run.status, why)].push_back(run.room);
  }
  if (roomsOf.empty()) return {};
  std::string list = "Without a sound walk:\n\n";
  for (const auto& [reason, rooms] : roomsOf)
    list += fmt::format("- {}: {}\n", reason, fmt::join(rooms, ", "));
  return list + "\n";
}

std::string agreementTable(const std::vector<BenchRun>& runs) {
  const std::vector<Agreement> found = agreements(runs);
  if (found.empty()) return {};
  Table table({"library", "rooms", "compared", "alike", "first that differs"});
  for (const Agreement& row : found) {
    const std::string first =
        row.differences.empty()
            ? "-"
            : fmt::format("{}, seed {}", row.differences.front()->room, row.differences.front()->seed);
    table.add({row.library, row.set, fmt::format("{}", row.compared),
               fmt::format("{}", row.compared - row.differences.size()), first});
  }
  return section("Native against WebAssembly",
                 "Guided walks of both, room by room and seed by seed: alike where status, edges and "
                 "expansions are the same.",
                 table);
}

/// A figure of growth; "-" where the row does not have it.
std::string growthCell(const GrowthRow& row, const std::string& name) {
  const auto found = std::find_if(row.figures.begin(), row.figures.end(),
                                  [&](const auto& figure) { return figure.first == name; });
  if (found == row.figures.end()) return "-";
  const double value = found->second;
  if (name.find(" / ") != std::string::npos) return fmt::format("{:.3f}", value);
  const bool isCount = !isTime(name) && value == std::floor(value);
  return isCount ? fmt::format("{:.0f}", value) : figure(value);
}

/// Names of the figures of a kind of growth, in their order.
Cells figureNames(const std::vector<GrowthRow>& rows, const std::string& kind) {
  Cells names;
  for (const GrowthRow& row : rows) {
    if (row.what != kind) continue;
    for (const auto& [name, value] : row.figures)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string aboutGrowth(const std::string& kind) {
  if (kind == "frames")
    return "Libraries built from varied takes of the default clips; walks through random rooms. Native.";
  if (kind == "rectangles") return "Blocks in a room of 120 m a side. Native.";
  if (kind == "walkers")
    return "Walkers evenly on a circle, all to the place opposite, planned together: the square is 20 m "
           "wide, or "
           "as wide as 2.7 m between neighbours take. Native.";
  return "Native.";
}

std::string growthTables(const std::vector<GrowthRow>& rows) {
  std::vector<std::string> kinds;
  for (const GrowthRow& row : rows)
    if (std::find(kinds.begin(), kinds.end(), row.what) == kinds.end()) kinds.push_back(row.what);
  std::string text;
  for (const std::string& kind : kinds) {
    const Cells names = figureNames(rows, kind);
    Cells heading = {kind};
    heading.insert(heading.end(), names.begin(), names.end());
    Table table(heading);
    for (const GrowthRow& row : rows) {
      if (row.what != kind) continue;
      Cells cells = {fmt::format("{:.0f}", row.size)};
      for (const std::string& name : names) cells.push_back(growthCell(row, name));
      table.add(cells);
    }
    text += section(fmt::format("Growth with {}", kind), aboutGrowth(kind), table);
  }
  return text;
}

}  // namespace

std::string benchTables(const BenchDocument& document) {
  std::string text = overviewTable(document.runs) + mapTables(document.runs);
  text += randomTable(document.runs) + failuresList(document.runs);
  text += agreementTable(document.runs);
  return text + growthTables(document.growth);
}

}  // namespace stridegraph::bench
