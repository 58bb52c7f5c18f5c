#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// What `stridegraph bench` measures, and how it tabulates and draws what was measured here or elsewhere.
namespace stridegraph::bench {

/// Sets of rooms, as in BenchRun::set.
inline constexpr const char* kMapsSet = "maps";
inline constexpr const char* kRandomSet = "random";

/// A room to measure in, and what is known of it beforehand.
struct BenchRoom {
  std::string set;
  std::string name;
  Scene scene;
  std::optional<double> shortestMetres;  ///< Of the disc, exactly; none where there is no way.
};

/// One plan or one path with one seed: what all tables are made of. Figures of a way are 0 unless there is
/// one.
struct BenchRun {
  std::string place;    ///< Where it ran: "native", "node".
  std::string library;  ///< Empty for paths without a walk.
  std::string set;
  std::string room;
  std::string method;  ///< A search's name, a planner's, or "exact".
  std::uint64_t seed = 0;
  std::string status;       ///< planStatusName() or pathStatusName().
  std::string explanation;  ///< As in PlanReport.
  std::optional<double> shortestMetres;
  double goalRadiusMetres = 0.0;
  double pathMilliseconds = 0.0;
  double motionMilliseconds = 0.0;
  double synthesisMilliseconds = 0.0;
  double totalMilliseconds = 0.0;  ///< With making the room ready.
  double expansions = 0.0;
  double lengthMetres = 0.0;
  double durationSeconds = 0.0;
  double transitions = 0.0;
  double blendedShare = 0.0;  ///< Of the frames, 0..1.
  double clearanceMetres = 0.0;
  double arrivalErrorMetres = 0.0;
  std::string edges;  ///< stableHash() of the edges played, in hexadecimal digits; empty without.
};

/// Whether a run ended as it should: where there is a way, it arrived within the goal radius and touched
/// nothing, by its own report; where there is none, it said so.
bool isSound(const BenchRun& run);

/// How something grows with the size of what it works on.
struct GrowthRow {
  std::string place;
  std::string what;  ///< "frames", "rectangles", "walkers".
  double size = 0.0;
  std::vector<std::pair<std::string, double>> figures;  ///< By name with unit: "build s".
};

/// Whether a figure of that name is a time, to its unit.
bool isTime(std::string_view figureName);

/// All that was measured.
struct BenchDocument {
  std::vector<BenchRun> runs;
  std::vector<GrowthRow> growth;
};

}  // namespace stridegraph::bench
