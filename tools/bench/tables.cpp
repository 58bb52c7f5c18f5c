#include "bench/tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/summary.h"
#include "walk/plan.h"

namespace stridegraph::bench {
namespace {

using Cells = std::vector<std::string>;

/// A Markdown table.
class Table {
 public:
  explicit Table(const Cells& heading) : text_(line(heading)) { text_ += line(Cells(heading.size(), "---")); }

  void add(const Cells& cells) { text_ += line(cells); }
  const std::string& text() const { return text_; }

 private:
  static std::string line(const Cells& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

  std::string text_;
};

std::string section(const std::string& title, const std::string& about, const Table& table) {
  return fmt::format("## {}\n\n{}\n\n{}\n", title, about, table.text());
}

/// Three digits, without needless ones behind the point.
std::string figure(double value) {
  if (value >= 99.95) return fmt::format("{:.0f}", value);
  if (value >= 9.995) return fmt::format("{:.1f}", value);
  return fmt::format("{:.2f}", value);
}

std::string medianAndWorst(const Spread& spread) {
  return fmt::format("{} / {}", figure(spread.median), figure(spread.worst));
}

std::string ratio(const Summary& summary) {
  if (summary.arrived == 0) return "-";
  return fmt::format("{:.3f} / {:.3f}", summary.lengthRatio.median, summary.lengthRatio.worst);
}

std::string expansions(const Summary& summary) {
  return fmt::format("{:.0f} / {:.0f}", summary.expansions.median, summary.expansions.worst);
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{}/{}", part, whole);
}

std::string percent(double value) {
  return fmt::format("{:.0f} %", 100.0 * value);
}

std::string placeTitle(const std::string& place) {
  return place == "node" ? "Node.js" : place;
}

/// Values in the order in which they first occur.
template <typename Get>
std::vector<std::string> distinct(const std::vector<Summary>& summaries, const Get& get) {
  std::vector<std::string> values;
  for (const Summary& summary : summaries)
    if (std::find(values.begin(), values.end(), get(summary)) == values.end()) values.push_back(get(summary));
  return values;
}

std::vector<Summary> chosen(const std::vector<Summary>& summaries, const std::string& library,
                            const std::string& place) {
  std::vector<Summary> of;
  std::copy_if(summaries.begin(), summaries.end(), std::back_inserter(of),
               [&](const Summary& summary) { return summary.library == library && summary.place == place; });
  return of;
}

const Summary* find(const std::vector<Summary>& summaries, const Summary& like, const std::string& place,
                    const std::string& method) {
  const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
    return summary.library == like.library && summary.room == like.room && summary.place == place &&
           summary.method == method;
  });
  return found == summaries.end() ? nullptr : &*found;
}

std::vector<std::string> librariesOf(const std::vector<Summary>& summaries) {
  std::vector<std::string> libraries = distinct(summaries, [](const Summary& s) { return s.library; });
  libraries.erase(std::remove(libraries.begin(), libraries.end(), std::string()), libraries.end());
  return libraries;
}

std::string guidedTable(const std::vector<Summary>& summaries, const std::string& library) {
  const std::string guided(searchName(SearchKind::kGuided));
  Table table({"map", "sound", "path ms", "motion ms", "synthesis ms", "total ms", "total ms, Node.js",
               "expansions", "length / shortest", "transitions / s", "blended"});
  std::size_t rows = 0;
  for (const Summary& row : chosen(summaries, library, "native")) {
    if (row.method != guided) continue;
    const Summary* node = find(summaries, row, "node", guided);
    table.add({row.room, share(row.sound, row.runs), medianAndWorst(row.pathMilliseconds),
               medianAndWorst(row.motionMilliseconds), medianAndWorst(row.synthesisMilliseconds),
               medianAndWorst(row.totalMilliseconds),
               node == nullptr ? "-" : medianAndWorst(node->totalMilliseconds), expansions(row), ratio(row),
               medianAndWorst(row.transitionsPerSecond), percent(row.blendedShare.median)});
    ++rows;
  }
  if (rows == 0) return {};
  return section(fmt::format("Walks with {}", library),
                 "The guided search, and path and synthesis around it. Median / worst of all seeds. A row is "
                 "sound where every walk arrives within the goal radius and touches nothing, or where what "
                 "cannot be is refused.",
                 table);
}

std::string searchesTable(const std::vector<Summary>& summaries, const std::string& library) {
  const std::vector<Summary> native = chosen(summaries, library, "native");
  Cells heading = {"map"};
  const std::vector<std::string> methods = distinct(native, [](const Summary& s) { return s.method; });
  if (methods.size() < 2) return {};
  for (const std::string& method : methods)
    for (const char* what : {"sound", "arrived", "ms", "length / shortest"})
      heading.push_back(fmt::format("{}: {}", method, what));
  Table table(heading);
  for (const Summary& row : native) {
    if (row.method != methods.front()) continue;
    Cells cells = {row.room};
    for (const std::string& method : methods) {
      const Summary* of = find(native, row, "native", method);
      if (of == nullptr) {
        cells.insert(cells.end(), 4, "-");
        continue;
      }
      cells.insert(cells.end(), {share(of->sound, of->runs), share(of->arrived, of->runs),
                                 medianAndWorst(of->totalMilliseconds), ratio(*of)});
    }
    table.add(cells);
  }
  return section(fmt::format("Three searches with {}", library),
                 "The thesis's search as printed does not look at obstacles; checked, it leaves out edges "
                 "that touch one. Both are stopped when their time is spent. Arrived: came to the goal, "
                 "whatever was touched. Native.",
                 table);
}

std::string pathsTable(const std::vector<Summary>& summaries) {
  const std::vector<Summary> paths = chosen(summaries, "", "native");
  if (paths.empty()) return {};
  const std::vector<std::string> methods = distinct(paths, [](const Summary& s) { return s.method; });
  Cells heading = {"map"};
  for (const std::string& method : methods)
    for (const char* what : {"sound", "ms", "length / shortest"})
      heading.push_back(fmt::format("{}: {}", method, what));
  Table table(heading);
  for (const Summary& row : paths) {
    if (row.method != methods.front()) continue;
    Cells cells = {row.room};
    for (const std::string& method : methods) {
      const Summary* of = find(paths, row, "native", method);
      if (of == nullptr) {
        cells.insert(cells.end(), 3, "-");
      } else {
        cells.insert(cells.end(),
                     {share(of->sound, of->runs), medianAndWorst(of->pathMilliseconds), ratio(*of)});
      }
    }
    table.add(cells);
  }
  return section("Paths",
                 "Paths of the disc alone, without making the room ready. Median / worst of all seeds. "
                 "Native.",
                 table);
}

std::string randomTable(const std::vector<BenchRun>& runs) {
  const std::vector<Summary> summaries = summariesOfSet(runs, kRandomSet);
  if (summaries.empty()) return {};
  Table table({"library", "place", "search", "sound", "ms: median", "90 %", "99 %", "worst",
               "length / shortest: median", "90 %", "worst", "transitions / s", "blended",
               "expansions: median", "99 %"});
  for (const Summary& row : summaries) {
    const double percentSound = 100.0 * static_cast<double>(row.sound) / static_cast<double>(row.runs);
    table.add({row.library, placeTitle(row.place), row.method,
               fmt::format("{} of {}: {:.1f} %", row.sound, row.runs, percentSound),
               figure(row.totalMilliseconds.median), figure(row.totalMilliseconds.p90),
               figure(row.totalMilliseconds.p99), figure(row.totalMilliseconds.worst),
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

std::string failuresList(const std::vector<BenchRun>& runs) {
  std::string list;
  for (const BenchRun& run : runs) {
    if (run.set != kRandomSet || isSound(run)) continue;
    list += fmt::format("- {}, {}, {}: {}", run.library, placeTitle(run.place), run.room, run.status);
    list += run.explanation.empty() ? "\n" : fmt::format(": {}\n", run.explanation);
  }
  if (list.empty()) return {};
  return fmt::format("Random rooms without a sound walk, and why:\n\n{}\n", list);
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

std::string growthTables(const std::vector<GrowthRow>& rows) {
  std::vector<std::string> kinds;
  for (const GrowthRow& row : rows)
    if (std::find(kinds.begin(), kinds.end(), row.what) == kinds.end()) kinds.push_back(row.what);
  std::string text;
  for (const std::string& kind : kinds) {
    const auto first =
        std::find_if(rows.begin(), rows.end(), [&](const GrowthRow& row) { return row.what == kind; });
    Cells heading = {kind};
    for (const auto& [name, value] : first->figures) heading.push_back(name);
    Table table(heading);
    for (const GrowthRow& row : rows) {
      if (row.what != kind) continue;
      Cells cells = {fmt::format("{:.0f}", row.size)};
      for (const auto& [name, value] : row.figures) cells.push_back(figure(value));
      table.add(cells);
    }
    text += section(fmt::format("Growth with {}", kind), "Native.", table);
  }
  return text;
}

}  // namespace

std::string benchTables(const BenchDocument& document) {
  const std::vector<Summary> maps = summariesByRoom(document.runs, kMapsSet);
  std::string text;
  for (const std::string& library : librariesOf(maps)) {
    text += guidedTable(maps, library);
    text += searchesTable(maps, library);
  }
  text += pathsTable(maps);
  text += randomTable(document.runs) + failuresList(document.runs);
  text += agreementTable(document.runs);
  return text + growthTables(document.growth);
}

}  // namespace stridegraph::bench
