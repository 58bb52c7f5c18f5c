#include "bench/summary.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "math/percentile.h"
#include "walk/plan.h"

namespace stridegraph::bench {
namespace {

using RunPointers = std::vector<const BenchRun*>;

bool hasArrived(const BenchRun& run) {
  return run.lengthMetres > 0.0 && run.shortestMetres;
}

template <typename Figure>
Spread spreadOver(const RunPointers& runs, const Figure& figure) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const BenchRun* run : runs) values.push_back(figure(*run));
  return spreadOf(std::move(values));
}

std::vector<std::pair<std::string, std::size_t>> countStatuses(const RunPointers& runs) {
  std::map<std::string, std::size_t> counts;
  for (const BenchRun* run : runs) ++counts[run->status];
  std::vector<std::pair<std::string, std::size_t>> statuses(counts.begin(), counts.end());
  std::stable_sort(statuses.begin(), statuses.end(),
                   [](const auto& one, const auto& other) { return one.second > other.second; });
  return statuses;
}

Summary summarise(const RunPointers& runs) {
  const BenchRun& first = *runs.front();
  Summary summary;
  summary.place = first.place;
  summary.library = first.library;
  summary.set = first.set;
  summary.room = first.room;
  summary.method = first.method;
  summary.shortestMetres = first.shortestMetres;
  RunPointers arrived;
  RunPointers refused;
  for (const BenchRun* run : runs) (hasArrived(*run) ? arrived : refused).push_back(run);
  summary.runs = runs.size();
  summary.arrived = arrived.size();
  summary.sound = static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const BenchRun* run) { return isSound(*run); }));
  summary.statuses = countStatuses(runs);
  summary.pathMilliseconds = spreadOver(runs, [](const BenchRun& run) { return run.pathMilliseconds; });
  summary.motionMilliseconds = spreadOver(runs, [](const BenchRun& run) { return run.motionMilliseconds; });
  summary.synthesisMilliseconds =
      spreadOver(arrived, [](const BenchRun& run) { return run.synthesisMilliseconds; });
  summary.totalMilliseconds = spreadOver(runs, [](const BenchRun& run) { return run.totalMilliseconds; });
  summary.refusedMilliseconds =
      spreadOver(refused, [](const BenchRun& run) { return run.totalMilliseconds; });
  summary.expansions = spreadOver(runs, [](const BenchRun& run) { return run.expansions; });
  summary.lengthRatio =
      spreadOver(arrived, [](const BenchRun& run) { return run.lengthMetres / *run.shortestMetres; });
  summary.transitionsPerSecond = spreadOver(arrived, [](const BenchRun& run) {
    return run.durationSeconds > 0.0 ? run.transitions / run.durationSeconds : 0.0;
  });
  summary.blendedShare = spreadOver(arrived, [](const BenchRun& run) { return run.blendedShare; });
  return summary;
}

/// Groups of runs whose keys are alike, in the order in which the keys first occur.
template <typename Key>
std::vector<RunPointers> grouped(std::span<const BenchRun> runs, const std::string& set, const Key& keyOf) {
  std::map<decltype(keyOf(runs.front())), std::size_t> groupOf;
  std::vector<RunPointers> groups;
  for (const BenchRun& run : runs) {
    if (run.set != set) continue;
    const auto [found, isNew] = groupOf.emplace(keyOf(run), groups.size());
    if (isNew) groups.emplace_back();
    groups[found->second].push_back(&run);
  }
  return groups;
}

bool chooseAlike(const BenchRun& one, const BenchRun& other) {
  return one.status == other.status && one.edges == other.edges && one.expansions == other.expansions;
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
  const double worst = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  return {percentile(values, 0.5), percentile(values, 0.9), percentile(values, 0.99), worst};
}

std::vector<Summary> summariesByRoom(std::span<const BenchRun> runs, const std::string& set) {
  std::vector<Summary> summaries;
  const auto key = [](const BenchRun& run) {
    return std::tuple(run.place, run.library, run.room, run.method);
  };
  for (const RunPointers& group : grouped(runs, set, key)) summaries.push_back(summarise(group));
  return summaries;
}

std::vector<Summary> summariesOfSet(std::span<const BenchRun> runs, const std::string& set) {
  std::vector<Summary> summaries;
  const auto key = [](const BenchRun& run) { return std::tuple(run.place, run.library, run.method); };
  for (const RunPointers& group : grouped(runs, set, key)) {
    summaries.push_back(summarise(group));
    summaries.back().room.clear();
    summaries.back().shortestMetres.reset();
  }
  return summaries;
}

std::vector<Agreement> agreements(std::span<const BenchRun> runs) {
  using Key = std::tuple<std::string, std::string, std::string, std::uint64_t>;
  const auto keyOf = [](const BenchRun& run) { return Key(run.library, run.set, run.room, run.seed); };
  const auto isCompared = [](const BenchRun& run) {
    return run.method == searchName(SearchKind::kGuided) && !run.library.empty();
  };
  std::map<Key, const BenchRun*> native;
  for (const BenchRun& run : runs)
    if (run.place == "native" && isCompared(run)) native.emplace(keyOf(run), &run);
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> indexOf;
  std::vector<Agreement> agreements;
  for (const BenchRun& run : runs) {
    const auto twin = native.find(keyOf(run));
    if (run.place == "native" || !isCompared(run) || twin == native.end()) continue;
    const auto [found, isNew] =
        indexOf.emplace(std::tuple(run.place, run.library, run.set), agreements.size());
    if (isNew) agreements.push_back({run.place, run.library, run.set, 0, {}});
    Agreement& agreement = agreements[found->second];
    ++agreement.compared;
    if (!chooseAlike(run, *twin->second)) agreement.differences.push_back(&run);
  }
  return agreements;
}

}  // namespace stridegraph::bench
