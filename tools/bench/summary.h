#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench_run.h"

namespace stridegraph::bench {

/// How values lie; all 0 without any.
struct Spread {
  double median = 0.0;
  double p90 = 0.0;
  double p99 = 0.0;
  double worst = 0.0;  ///< The largest.
};

Spread spreadOf(std::vector<double> values);

/// Some runs of one method, summed up. Times are of all of them; the figures of walks are of those that
/// arrived.
struct Summary {
  std::string place, library, set, room, method;  ///< room is empty where several are summed up.
  std::size_t runs = 0;
  std::size_t sound = 0;
  std::size_t arrived = 0;
  std::vector<std::pair<std::string, std::size_t>> statuses;  ///< How often each, the most frequent first.
  std::optional<double> shortestMetres;                       ///< Of the room, where it is one.
  Spread pathMilliseconds, motionMilliseconds, synthesisMilliseconds, totalMilliseconds;
  Spread refusedMilliseconds;  ///< Total, of those that did not arrive.
  Spread expansions;
  Spread lengthRatio;  ///< Over the shortest path.
  Spread transitionsPerSecond;
  Spread blendedShare;
};

/// A summary for each place, library, room and method of a set, in the order in which they first occur.
std::vector<Summary> summariesByRoom(std::span<const BenchRun> runs, const std::string& set);

/// A summary for each place, library and method of a set.
std::vector<Summary> summariesOfSet(std::span<const BenchRun> runs, const std::string& set);

/// How far two places agree on what the guided search chose.
struct Agreement {
  std::string place, library, set;
  std::size_t compared = 0;                  ///< Runs of that place that were also made natively.
  std::vector<const BenchRun*> differences;  ///< Those with another status, other edges or expansions.
};

/// For each place but "native", library and set.
std::vector<Agreement> agreements(std::span<const BenchRun> runs);

}  // namespace stridegraph::bench
