#include "bench/map_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/table_text.h"
#include "walk/plan.h"

namespace stridegraph::bench {
namespace {

constexpr double kLongMetres = 100.0;

std::string expansions(const Summary& summary) {
  return fmt::format("{:.0f} / {:.0f}", summary.expansions.median, summary.expansions.worst);
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{}/{}", part, whole);
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
  return section(fmt::format("Searches with {}", library),
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
  const bool hasOmpl = std::any_of(methods.begin(), methods.end(),
                                   [](const std::string& method) { return method.starts_with("ompl-"); });
  std::string about =
      "Paths of the disc alone, without making the room ready. Median / worst of all seeds. Native.";
  if (hasOmpl)
    about +=
        " OMPL's planners ask the same exact questions of the room and have their paths simplified by OMPL, "
        "as "
        "ours by us; they stop after 1 s and cannot say that there is no way. BIT* goes on for 50 ms to find "
        "shorter ones.";
  return section("Paths", about, table);
}

/// The largest of some figures and the room it is of.
struct Extreme {
  double value = 0.0;
  std::string room;

  void take(double other, const std::string& of) {
    if (other <= value) return;
    value = other;
    room = of;
  }
};

/// What is worst among rooms.
struct Overview {
  std::string library, place, method;
  bool isLong = false;
  std::size_t runs = 0;
  std::size_t sound = 0;
  Extreme medianMilliseconds, worstMilliseconds, medianRatio, worstRatio, transitionsPerSecond;

  void take(const Summary& row) {
    runs += row.runs;
    sound += row.sound;
    medianMilliseconds.take(row.totalMilliseconds.median, row.room);
    worstMilliseconds.take(row.totalMilliseconds.worst, row.room);
    medianRatio.take(row.lengthRatio.median, row.room);
    worstRatio.take(row.lengthRatio.worst, row.room);
    transitionsPerSecond.take(row.transitionsPerSecond.median, row.room);
  }
};

std::vector<Overview> overviews(const std::vector<BenchRun>& runs) {
  std::vector<Overview> found;
  for (const Summary& row : summariesByRoom(runs, kMapsSet)) {
    if (!row.method.starts_with(searchName(SearchKind::kGuided)) || !row.shortestMetres) continue;
    const bool isLong = *row.shortestMetres > kLongMetres;
    auto of = std::find_if(found.begin(), found.end(), [&](const Overview& overview) {
      return overview.library == row.library && overview.place == row.place &&
             overview.method == row.method && overview.isLong == isLong;
    });
    if (of == found.end())
      of = found.insert(found.end(), {row.library, row.place, row.method, isLong, 0, 0, {}, {}, {}, {}, {}});
    of->take(row);
  }
  return found;
}

}  // namespace

std::string overviewTable(const std::vector<BenchRun>& runs) {
  const std::vector<Overview> found = overviews(runs);
  if (found.empty()) return {};
  Table table({"library", "place", "search", "maps", "sound", "slowest map: median ms", "worst run ms",
               "longest map: median length / shortest", "worst", "most transitions / s"});
  const auto of = [](const std::string& value, const Extreme& extreme) {
    return fmt::format("{} ({})", value, extreme.room);
  };
  for (const Overview& row : found) {
    table.add({row.library, placeTitle(row.place), row.method, row.isLong ? "above 100 m" : "up to 100 m",
               share(row.sound, row.runs), of(figure(row.medianMilliseconds.value), row.medianMilliseconds),
               of(figure(row.worstMilliseconds.value), row.worstMilliseconds),
               of(fmt::format("{:.3f}", row.medianRatio.value), row.medianRatio),
               of(fmt::format("{:.3f}", row.worstRatio.value), row.worstRatio),
               of(figure(row.transitionsPerSecond.value), row.transitionsPerSecond)});
  }
  return section(
      "Guided walks at their worst",
      "Over all maps where there is a way: the largest of their medians, and the worst of all "
      "walks. Milliseconds are of path, search and synthesis together; guided takes the first walk, "
      "guided-improved looks for better ones for a while (50 ms unless told otherwise).",
      table);
}

std::string mapTables(const std::vector<BenchRun>& runs) {
  const std::vector<Summary> maps = summariesByRoom(runs, kMapsSet);
  std::string text;
  for (const std::string& library : librariesOf(maps)) {
    text += guidedTable(maps, library);
    text += searchesTable(maps, library);
  }
  return text + pathsTable(maps);
}

}  // namespace stridegraph::bench
