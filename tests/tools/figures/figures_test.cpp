#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "figures/figure.h"
#include "graph/library_builder.h"
#include "motion/gait_library.h"
#include "motion/gait_skeleton.h"
#include "scene/scene_json.h"

namespace stridegraph::figures {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// A tag whose attributes are empty, since some hold whole images; as it is where a value holds a '<'.
std::string withoutValues(const std::string& tag) {
  if (tag.find('<', 1) != std::string::npos) return tag;
  std::string bare;
  bool inside = false;
  for (const char c : tag) {
    if (c == '"') inside = !inside;
    if (!inside || c == '"') bare += c;
  }
  return bare;
}

/// What is wrong with a text as XML, as far as elements go: every one is closed, in order, and one holds all.
std::string faultInXml(const std::string& text) {
  static const std::regex kTag(
      "<(/?)([A-Za-z][A-Za-z0-9]*)((?:\\s+[A-Za-z][A-Za-z0-9:-]*=\"[^\"<]*\")*)\\s*(/?)>");
  std::vector<std::string> open;
  std::size_t at = text.find("<!DOCTYPE html>") == 0 ? 15 : 0;
  bool closedAll = false;
  for (; at < text.size();) {
    const std::size_t next = text.find('<', at);
    if (next == std::string::npos) break;
    const std::size_t end = text.find('>', next);
    if (end == std::string::npos) return "an open '<'";
    const std::string tag = withoutValues(text.substr(next, end - next + 1));
    std::smatch match;
    if (!std::regex_match(tag, match, kTag)) return "not a tag: " + tag.substr(0, 80);
    if (closedAll) return "more than one outermost element";
    if (match[1].length() > 0) {
      if (open.empty() || open.back() != match[2].str()) return "closed, but not open: " + match[2].str();
      open.pop_back();
    } else if (match[4].length() == 0) {
      open.push_back(match[2].str());
    }
    closedAll = open.empty();
    at = end + 1;
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

/// A library of few clips, so that the test is quick: it can walk, turn, start and stop.
std::shared_ptr<const MotionLibrary> smallLibrary() {
  const std::set<std::string> names = {"walk_1.0",
                                       "walk_1.3",
                                       "stand",
                                       "start_left",
                                       "start_right",
                                       "stop_left",
                                       "stop_right",
                                       "walk_tight_90_left",
                                       "walk_tight_90_right",
                                       "walk_tight_45_left",
                                       "walk_tight_45_right",
                                       "turn_on_the_spot_90_left",
                                       "turn_on_the_spot_90_right"};
  std::vector<BvhDocument> documents;
  for (Clip& clip : defaultGaitClips()) {
    if (names.count(clip.name) > 0)
      documents.push_back({gaitSkeleton(), gaitBvhLayout(), std::move(clip), {}});
  }
  auto built = buildLibrary(std::move(documents), {.thresholdMetres = 0.04});
  EXPECT_TRUE(built.has_value());
  return std::make_shared<const MotionLibrary>(std::move(built->library));
}

Scene roomWithBlock() {
  Scene scene;
  scene.name = "Block & \"corner\"";
  scene.widthMetres = 9.0;
  scene.depthMetres = 7.0;
  scene.obstacles = {{{4.5, 2.5}, {1.0, 3.0}}};
  scene.start = {{1.5, 2.0}, Angle::degrees(90.0)};
  scene.goal = {{7.5, 2.0}, Angle::degrees(90.0)};
  return scene;
}

void expectOnItsPaper(const Figure& figure) {
  EXPECT_GE(figure.svg.drawn().left, 0.0) << figure.name;
  EXPECT_GE(figure.svg.drawn().top, 0.0) << figure.name;
  EXPECT_LE(figure.svg.drawn().right, figure.svg.width()) << figure.name;
  EXPECT_LE(figure.svg.drawn().bottom, figure.svg.height()) << figure.name;
}

void expectNoLabelsOnTopOfEachOther(const Figure& figure) {
  const auto& labels = figure.svg.labels();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      const PixelBox& a = labels[i].box;
      const PixelBox& b = labels[j].box;
      EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
          << figure.name << ": " << labels[i].text << " / " << labels[j].text;
    }
  }
}

// One test, since drawing everything takes seconds and each test is a process of its own.
TEST(Figures, showEveryStageLegiblyAndTheSameEveryTime) {
  const FigureInputs inputs{std::make_shared<const WalkPlanner>(smallLibrary()), {roomWithBlock()}};
  std::set<std::string> names;
  for (const FigureSection& section : makeFigures(inputs)) {
    for (const Figure& figure : section.figures) {
      EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
      EXPECT_FALSE(figure.caption.empty()) << figure.name;
      expectOnItsPaper(figure);
      expectNoLabelsOnTopOfEachOther(figure);
    }
    if (section.title != "Arrival") continue;
    ASSERT_EQ(section.figures.size(), 1U);
    EXPECT_EQ(arrivalFigures(inputs)[0].svg.finish(), section.figures[0].svg.finish());
  }
  for (const char* expected :
       {"strip", "poses", "foot_contacts", "foot_cleanup", "similarity_matrix", "root_paths", "motion_graph",
        "paths_block____corner_", "walk_block____corner_", "arrival"})
    EXPECT_EQ(names.count(expected), 1U) << expected;
}

TEST(IndexPage, showsFoldersMadeElsewhere) {
  const std::string page =
      indexPage({}, {{"captures", true, {"walk"}, ""}, {"fit", false, {"lean"}, "5 < 6"}}, "About & more");
  EXPECT_EQ(faultInXml(page), "");
  EXPECT_NE(page.find("About &amp; more"), std::string::npos);
  EXPECT_NE(page.find("href=\"captures/index.html\""), std::string::npos);
  EXPECT_EQ(page.find("captures/walk.svg"), std::string::npos);
  EXPECT_NE(page.find("src=\"fit/lean.svg\""), std::string::npos);
  EXPECT_NE(page.find("<pre>5 &lt; 6</pre>"), std::string::npos);
}

TEST(FaultInXml, findsWhatIsWrong) {
  EXPECT_EQ(faultInXml("<a b=\"c\"><d/></a>"), "");
  EXPECT_NE(faultInXml("<a><b></a>"), "");
  EXPECT_NE(faultInXml("<a>"), "");
  EXPECT_NE(faultInXml("<a b=c></a>"), "");
  EXPECT_NE(faultInXml("<a></a><b></b>"), "");
}

TEST(FiguresCommand, writesEveryFileOfItsIndexAsWellFormedXml) {
  const fs::path folder = fs::path(::testing::TempDir()) / "stridegraph_figures_test";
  fs::remove_all(folder);
  fs::create_directories(folder / "scenes");
  std::ofstream(folder / "scenes" / "block.json") << writeSceneJson(roomWithBlock());
  const std::string program = STRIDEGRAPH_PROGRAM;
  const auto run = [&](const std::string& arguments) {
    return std::system((program + " " + arguments + " > " + (folder / "log").string() + " 2>&1").c_str());
  };
  ASSERT_EQ(run("gait -o " + (folder / "clips").string()), 0);
  const std::string clips = (folder / "clips").string();
  ASSERT_EQ(run("build " + clips + "/walk_1.*.bvh " + clips + "/walk_tight_90_left.bvh " + clips +
                "/walk_tight_90_right.bvh -o " + (folder / "small.sgraph").string()),
            0)
      << contentOf(folder / "log");
  ASSERT_EQ(run("figures --graph " + (folder / "small.sgraph").string() + " --scenes " +
                (folder / "scenes").string() + " -o " + (folder / "out").string()),
            0)
      << contentOf(folder / "log");
  const std::string index = contentOf(folder / "out" / "index.html");
  EXPECT_EQ(faultInXml(index), "");
  static const std::regex kImage("<img src=\"([^\"]+)\"");
  std::size_t images = 0;
  for (std::sregex_iterator it(index.begin(), index.end(), kImage), end; it != end; ++it, ++images) {
    const fs::path file = folder / "out" / (*it)[1].str();
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_EQ(faultInXml(contentOf(file)), "") << file;
  }
  EXPECT_GE(images, 5U);
  fs::remove_all(folder);
}

TEST(FiguresCommand, namesALibraryThatItCannotRead) {
  const fs::path log = fs::path(::testing::TempDir()) / "stridegraph_figures_log";
  const std::string command = std::string(STRIDEGRAPH_PROGRAM) + " figures --graph /nowhere.sgraph -o " +
                              (log.string() + "_out") + " > " + log.string() + " 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(contentOf(log).find("/nowhere.sgraph"), std::string::npos);
  fs::remove(log);
}

}  // namespace
}  // namespace stridegraph::figures
