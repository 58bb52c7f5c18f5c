#include <gtest/gtest.h>

#include "bench/bench_run.h"
#include "bench/document_json.h"
#include "bench/summary.h"
#include "bench/tables.h"

namespace stridegraph::bench {
namespace {

/// A walk of 22 m where 20 m are the shortest, with 6 transitions in 10 s.
BenchRun arrivedRun(std::uint64_t seed = 1) {
  BenchRun run;
  run.place = "native";
  run.library = "default";
  run.set = kMapsSet;
  run.room = "01_empty";
  run.method = "guided";
  run.seed = seed;
  run.status = "arrived";
  run.shortestMetres = 20.0;
  run.goalRadiusMetres = 0.1;
  run.pathMilliseconds = 1.0;
  run.motionMilliseconds = 2.0;
  run.synthesisMilliseconds = 3.0;
  run.totalMilliseconds = 7.0;
  run.expansions = 100.0;
  run.lengthMetres = 22.0;
  run.durationSeconds = 10.0;
  run.transitions = 6.0;
  run.blendedShare = 0.25;
  run.clearanceMetres = 0.05;
  run.arrivalErrorMetres = 0.01;
  run.edges = "0123456789abcdef";
  return run;
}

BenchRun refusedRun(const std::string& status) {
  BenchRun run = arrivedRun();
  run.status = status;
  run.explanation = "why not";
  run.lengthMetres = run.durationSeconds = run.transitions = run.blendedShare = 0.0;
  run.edges.clear();
  return run;
}

TEST(BenchRun, isSoundWhenItArrivesAndTouchesNothing) {
  EXPECT_TRUE(isSound(arrivedRun()));
  BenchRun far = arrivedRun();
  far.arrivalErrorMetres = 0.11;
  EXPECT_FALSE(isSound(far));
  BenchRun touching = arrivedRun();
  touching.clearanceMetres = -0.001;
  EXPECT_FALSE(isSound(touching));
  EXPECT_FALSE(isSound(refusedRun("no_motion")));
  EXPECT_FALSE(isSound(refusedRun("no_path"))) << "there is one";
}

TEST(BenchRun, isSoundWhenWhatCannotBeIsRefused) {
  for (const char* status : {"no_path", "start_blocked", "goal_blocked"}) {
    BenchRun run = refusedRun(status);
    run.shortestMetres.reset();
    EXPECT_TRUE(isSound(run)) << status;
  }
  BenchRun run = arrivedRun();
  run.shortestMetres.reset();
  EXPECT_FALSE(isSound(run)) << "it went through a wall";
  run = refusedRun("no_motion");
  run.shortestMetres.reset();
  EXPECT_FALSE(isSound(run)) << "that is not the reason";
}

TEST(Spread, tellsHowValuesLie) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(100.0 - i);
  const Spread spread = spreadOf(values);
  EXPECT_DOUBLE_EQ(spread.median, 50.0);
  EXPECT_DOUBLE_EQ(spread.p90, 90.0);
  EXPECT_DOUBLE_EQ(spread.p99, 99.0);
  EXPECT_DOUBLE_EQ(spread.worst, 100.0);
  EXPECT_EQ(spreadOf({}).worst, 0.0);
}

TEST(Summary, holdsTheRunsOfARoomAndMethod) {
  BenchRun slow = arrivedRun(2);
  slow.totalMilliseconds = 9.0;
  slow.lengthMetres = 26.0;
  BenchRun elsewhere = arrivedRun();
  elsewhere.place = "node";
  BenchRun random = arrivedRun();
  random.set = kRandomSet;
  const std::vector<BenchRun> runs = {arrivedRun(), slow, refusedRun("no_motion"), elsewhere, random};
  const std::vector<Summary> summaries = summariesByRoom(runs, kMapsSet);
  ASSERT_EQ(summaries.size(), 2U);
  const Summary& native = summaries.front();
  EXPECT_EQ(native.place, "native");
  EXPECT_EQ(native.runs, 3U);
  EXPECT_EQ(native.sound, 2U);
  EXPECT_EQ(native.arrived, 2U);
  EXPECT_EQ(native.statuses.front(), std::pair(std::string("arrived"), std::size_t{2}));
  EXPECT_EQ(native.statuses.back().first, "no_motion");
  EXPECT_DOUBLE_EQ(native.totalMilliseconds.median, 7.0);
  EXPECT_DOUBLE_EQ(native.totalMilliseconds.worst, 9.0);
  EXPECT_DOUBLE_EQ(native.lengthRatio.median, 1.2) << "of those that arrived: 1.1 and 1.3";
  EXPECT_DOUBLE_EQ(native.lengthRatio.worst, 1.3);
  EXPECT_DOUBLE_EQ(native.transitionsPerSecond.median, 0.6);
  EXPECT_EQ(summaries.back().place, "node");
}

TEST(Summary, holdsAllRoomsOfASet) {
  BenchRun other = arrivedRun();
  other.room = "02_one_obstacle";
  const std::vector<BenchRun> runs = {arrivedRun(), other};
  const std::vector<Summary> summaries = summariesOfSet(runs, kMapsSet);
  ASSERT_EQ(summaries.size(), 1U);
  EXPECT_EQ(summaries.front().runs, 2U);
  EXPECT_EQ(summaries.front().room, "");
  EXPECT_TRUE(summariesOfSet(runs, kRandomSet).empty());
}

TEST(Agreement, tellsWhichRunsDiffer) {
  BenchRun alike = arrivedRun(1);
  alike.place = "node";
  alike.totalMilliseconds = 99.0;
  BenchRun otherEdges = arrivedRun(2);
  otherEdges.place = "node";
  otherEdges.edges = "fedcba9876543210";
  BenchRun alone = arrivedRun(3);
  alone.place = "node";
  const std::vector<BenchRun> runs = {arrivedRun(1), arrivedRun(2), alike, otherEdges, alone};
  const std::vector<Agreement> found = agreements(runs);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().compared, 2U) << "the third has no twin";
  ASSERT_EQ(found.front().differences.size(), 1U);
  EXPECT_EQ(found.front().differences.front()->seed, 2U);
}

TEST(BenchJson, bringsEveryFigureBack) {
  BenchDocument document;
  document.runs = {arrivedRun(4), refusedRun("no_motion")};
  document.growth = {{"native", "frames", 1000.0, {{"build s", 0.5}}}};
  BenchDocument back;
  ASSERT_TRUE(joinBenchJson(writeBenchJson(document), "a.json", back).has_value());
  EXPECT_EQ(writeBenchJson(back), writeBenchJson(document));
  EXPECT_EQ(back.runs.front().seed, 4U);
  EXPECT_EQ(back.runs.front().edges, "0123456789abcdef");
  EXPECT_EQ(*back.runs.front().shortestMetres, 20.0);
  EXPECT_EQ(back.growth.front().figures.front().second, 0.5);
}

TEST(BenchJson, takesShortestPathsFromTheSameRoom) {
  BenchDocument document;
  document.runs = {arrivedRun()};
  const std::string text =
      R"({"runs": [{"place": "node", "set": "maps", "room": "01_empty", "status": "arrived"}]})";
  ASSERT_TRUE(joinBenchJson(text, "node.json", document).has_value());
  EXPECT_EQ(document.runs.back().place, "node");
  EXPECT_EQ(document.runs.back().shortestMetres, 20.0);
}

TEST(BenchJson, refusesWhatHoldsNoRuns) {
  BenchDocument document;
  for (const char* text : {"", "[]", "{}", R"({"runs": 3})"}) {
    const Result<void> joined = joinBenchJson(text, "other.json", document);
    ASSERT_FALSE(joined.has_value()) << text;
    EXPECT_EQ(describe(joined.error()),
              "other.json: found no list of runs, expected what bench --json writes");
  }
}

TEST(BenchTables, haveARowForEachMapWithBothPlaces) {
  BenchDocument document;
  BenchRun node = arrivedRun();
  node.place = "node";
  node.totalMilliseconds = 12.5;
  BenchRun thesis = refusedRun("budget_spent");
  thesis.method = "thesis";
  document.runs = {arrivedRun(), thesis, node};
  const std::string tables = benchTables(document);
  EXPECT_NE(tables.find("## Walks with default"), std::string::npos);
  EXPECT_NE(
      tables.find("| 01_empty | 1/1 | 1.00 / 1.00 | 2.00 / 2.00 | 3.00 / 3.00 | 7.00 / 7.00 | 12.5 / 12.5 "
                  "| 100 / 100 | 1.100 / 1.100 | 0.60 / 0.60 | 25 % |"),
      std::string::npos)
      << tables;
  EXPECT_NE(
      tables.find("| 01_empty | 1/1 | 1/1 | 7.00 / 7.00 | 1.100 / 1.100 | 0/1 | 0/1 | 7.00 / 7.00 | - |"),
      std::string::npos)
      << tables;
  EXPECT_NE(tables.find("| default | maps | 1 | 1 | - |"), std::string::npos);
}

TEST(BenchTables, nameEveryRandomRoomThatFails) {
  BenchDocument document;
  BenchRun failed = refusedRun("no_motion");
  failed.set = kRandomSet;
  failed.room = "room_0007";
  BenchRun good = arrivedRun();
  good.set = kRandomSet;
  document.runs = {failed, good};
  const std::string tables = benchTables(document);
  EXPECT_NE(tables.find("| default | native | guided | 1 of 2: 50.0 % |"), std::string::npos) << tables;
  EXPECT_NE(tables.find("- default: no_motion (why not): room_0007\n"), std::string::npos) << tables;
}

TEST(BenchTables, showGrowth) {
  BenchDocument document;
  document.growth = {{"native", "frames", 1000.0, {{"build s", 0.5}}},
                     {"native", "rectangles", 10.0, {{"path ms", 2.0}}},
                     {"native", "frames", 3000.0, {{"build s", 4.0}}}};
  const std::string tables = benchTables(document);
  EXPECT_NE(tables.find("| frames | build s |\n| --- | --- |\n| 1000 | 0.50 |\n| 3000 | 4.00 |\n"),
            std::string::npos)
      << tables;
  EXPECT_NE(tables.find("| rectangles | path ms |"), std::string::npos);
}

TEST(BenchTables, showCountsAndRatiosOfGrowthAndWhatARowLacks) {
  BenchDocument document;
  document.growth = {
      {"native", "walkers", 1.0, {{"arrived", 1.0}, {"all ms", 4.0}, {"length / shortest", 1.0}}},
      {"native",
       "walkers",
       2.0,
       {{"arrived", 2.0}, {"all ms", 6.5}, {"length / shortest", 1.0214}, {"least gap m", 0.04}}}};
  const std::string tables = benchTables(document);
  EXPECT_NE(tables.find("| walkers | arrived | all ms | length / shortest | least gap m |\n"
                        "| --- | --- | --- | --- | --- |\n"
                        "| 1 | 1 | 4.00 | 1.000 | - |\n"
                        "| 2 | 2 | 6.50 | 1.021 | 0.04 |\n"),
            std::string::npos)
      << tables;
}

TEST(BenchTables, leaveOutWhatWasNotMeasured) {
  EXPECT_EQ(benchTables({}), "");
}

}  // namespace
}  // namespace stridegraph::bench
