#include "bench/picture.h"

#include <gtest/gtest.h>

#include "bench/chart.h"

namespace stridegraph::bench {
namespace {

std::vector<std::string> labelsOf(const Scale& scale) {
  std::vector<std::string> labels;
  for (const Scale::Tick& tick : scale.ticks()) labels.push_back(tick.label);
  return labels;
}

TEST(Scale, hasRoundNumbersFromItsBeginningToWhatHoldsAll) {
  const Scale scale = Scale::linear(1.0, 1.12);
  EXPECT_EQ(labelsOf(scale).front(), "1");
  EXPECT_EQ(scale.share(1.0), 0.0);
  EXPECT_LE(scale.share(1.12), 1.0);
  EXPECT_NEAR(scale.share(scale.ticks().back().value), 1.0, 1e-9);
  EXPECT_EQ(scale.share(5.0), 1.0) << "beyond its end";
}

TEST(Scale, isLogarithmicInRoundNumbers) {
  const Scale fine = Scale::logarithmic(3.0, 40.0);
  EXPECT_EQ(labelsOf(fine), (std::vector<std::string>{"2", "5", "10", "20", "50"}));
  EXPECT_NEAR(fine.share(10.0), 0.5, 1e-9) << "half way from 2 to 50";
  EXPECT_EQ(fine.share(0.0), 0.0);
  const Scale coarse = Scale::logarithmic(0.01, 1500.0);
  EXPECT_EQ(labelsOf(coarse), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100", "1000"}));
  EXPECT_EQ(coarse.share(2000.0), 1.0);
  EXPECT_EQ(labelsOf(Scale::logarithmic(1000.0, 1000.0)).size(), 4U) << "1000 to 10000";
}

/// Runs of two libraries on three maps, natively and in Node.js, in random rooms, and growth.
BenchDocument fullDocument() {
  BenchDocument document;
  const auto add = [&](const char* place, const char* library, const char* set, const std::string& room,
                       const char* method) {
    BenchRun run;
    run.place = place;
    run.library = library;
    run.set = set;
    run.room = room;
    run.method = method;
    run.status = "arrived";
    run.shortestMetres = 20.0;
    run.lengthMetres = 21.0;
    run.goalRadiusMetres = 0.1;
    run.pathMilliseconds = 1.0;
    run.totalMilliseconds = 5.0 + static_cast<double>(document.runs.size());
    document.runs.push_back(run);
  };
  for (const char* map : {"01_empty", "02_one_obstacle", "08_stress"}) {
    for (const char* library : {"default", "a_library_with_a_long_name_of_its_own"}) {
      for (const char* method : {"guided", "thesis", "thesis-checked"})
        add("native", library, kMapsSet, map, method);
      add("node", library, kMapsSet, map, "guided");
      add("native", library, kRandomSet, map, "guided");
      add("node", library, kRandomSet, map, "guided");
    }
    for (const char* method : {"exact", "prm", "rrt-connect"}) add("native", "", kMapsSet, map, method);
  }
  document.growth = {{"native", "frames", 1000.0, {{"build s", 0.03}, {"nodes", 500.0}, {"open ms", 20.0}}},
                     {"native", "frames", 10000.0, {{"build s", 3.0}, {"nodes", 7000.0}, {"open ms", 500.0}}},
                     {"native", "rectangles", 0.0, {{"walk ms", 30.0}}},
                     {"native", "rectangles", 100.0, {{"walk ms", 40.0}}},
                     {"native", "rectangles", 2000.0, {{"walk ms", 90.0}}},
                     {"native", "walkers", 1.0, {{"all ms", 4.0}, {"slowest walker ms", 4.0}}},
                     {"native", "walkers", 100.0, {{"all ms", 4000.0}, {"slowest walker ms", 300.0}}}};
  return document;
}

bool overlap(const figures::PixelBox& one, const figures::PixelBox& other) {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

bool hasLabel(const figures::Svg& svg, const std::string& text) {
  return std::any_of(svg.labels().begin(), svg.labels().end(),
                     [&](const figures::Svg::Label& label) { return label.text == text; });
}

TEST(BenchPicture, hasAPanelForEverythingMeasured) {
  const figures::Svg svg = benchPicture(fullDocument());
  for (const char* title :
       {"Time to a walk", "Length over the shortest path", "Three searches", "Paths of the disc",
        "Random rooms", "Growth with frames", "Growth with rectangles", "Growth with walkers",
        "slowest walker", "08_stress", "thesis-checked", "rrt-connect"})
    EXPECT_TRUE(hasLabel(svg, title)) << title;
}

TEST(BenchPicture, keepsWithinItsPaperAndItsTextsApart) {
  const figures::Svg svg = benchPicture(fullDocument());
  EXPECT_GE(svg.drawn().left, 0.0);
  EXPECT_GE(svg.drawn().top, 0.0);
  EXPECT_LE(svg.drawn().right, svg.width());
  EXPECT_LE(svg.drawn().bottom, svg.height());
  const auto& labels = svg.labels();
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = i + 1; j < labels.size(); ++j)
      EXPECT_FALSE(overlap(labels[i].box, labels[j].box)) << labels[i].text << " and " << labels[j].text;
}

TEST(BenchPicture, leavesOutWhatWasNotMeasured) {
  BenchDocument document = fullDocument();
  document.growth.clear();
  std::erase_if(document.runs, [](const BenchRun& run) { return run.set != kRandomSet; });
  const figures::Svg svg = benchPicture(document);
  EXPECT_TRUE(hasLabel(svg, "Random rooms"));
  EXPECT_FALSE(hasLabel(svg, "Time to a walk"));
  EXPECT_FALSE(hasLabel(svg, "Growth with frames"));
  EXPECT_LT(benchPicture({}).height(), svg.height());
}

TEST(BenchPicture, leavesOutGrowthThatHasNoSize) {
  BenchDocument document;
  document.growth = {{"native", "rectangles", 0.0, {{"walk ms", 30.0}}}};
  EXPECT_FALSE(hasLabel(benchPicture(document), "Growth with rectangles"));
}

}  // namespace
}  // namespace stridegraph::bench
