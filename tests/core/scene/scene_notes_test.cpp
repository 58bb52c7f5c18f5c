#include "scene/scene_notes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "math/random.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"
#include "scene/scene_members.h"
#include "scene/test_scenes.h"

namespace stridegraph {
namespace {

const std::string kOuterNames =
    "version, name, width, depth, obstacles, moving, start, goal, walkers, constraints, radius or seed";

std::vector<std::string> notesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (const Warning& note : sceneNotes(text, "room.json")) {
    EXPECT_EQ(note.topic, WarningTopic::kScene);
    lines.push_back(describe(note));
  }
  return lines;
}

std::string caseText(const std::string& name) {
  std::ifstream file(std::string(STRIDEGRAPH_CASES) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

using Lines = std::vector<std::string>;

TEST(SceneNotes, haveNothingToSayOfWhatIsWritten) {
  Random random(61);
  for (int i = 0; i < 100; ++i) {
    Scene scene = randomScene(random);
    scene.unknownMembers.clear();
    EXPECT_EQ(notesOf(writeSceneJson(scene)), Lines());
  }
}

TEST(SceneNotes, nameWhatIsMisspelt) {
  Warnings notes;
  const Result<Scene> scene = readSceneJson(caseText("misspelt_members.json"), "room.json", &notes);
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_FALSE(scene->start.heading);
  EXPECT_FALSE(scene->constraints.any());
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(describe(notes[0]),
            "room.json:1:83: found start.heading, which has no effect; did you mean heading_deg?");
  EXPECT_EQ(describe(notes[1]),
            "room.json:1:125: found constraint, which has no effect; did you mean constraints?");
}

TEST(SceneNotes, nameWhatIsGivenTwiceWithItsPlace) {
  EXPECT_EQ(
      notesOf("{\n \"seed\": 1,\n  \"seed\": 2, \"start\": {\"x\": 1, \"x\": 2, \"x\": 3}}"),
      Lines({"room.json:3:3: found seed more than once, the last one counts",
             "room.json:3:32: found start.x more than once, the last one counts (and 1 more like it)"}));
}

TEST(SceneNotes, takeTheLastOfTwoAsTheReaderDoes) {
  Warnings notes;
  const Result<Scene> scene = readSceneJson(
      R"({"width": 5, "width": 7, "depth": 6, "obstacles": [], "start": {"x": 1, "z": 1}, "goal": {"x": 4, "z": 5}})",
      "room.json", &notes);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->widthMetres, 7.0);
  EXPECT_EQ(notes.size(), 1U);
}

TEST(SceneNotes, lookIntoEveryKindOfObject) {
  EXPECT_EQ(
      notesOf(R"({"obstacles": [{"widht": 1}], "moving": [{"loop": 1, "track": [{"time": 0}]}],
"goal": {"y": 2}, "walkers": [{}, {"goal": {"z": 1, "heading_degrees": 3}}],
"constraints": {"speed": 1, "areas": [{"knd": "avoid"}]}})"),
      Lines({"room.json:1:17: found obstacles[0].widht, which has no effect; did you mean width?",
             "room.json:1:43: found moving[0].loop, which has no effect; expected width, depth, repeat or "
             "track",
             "room.json:1:65: found moving[0].track[0].time, which has no effect; expected t, x or z",
             "room.json:2:10: found goal.y, which has no effect; expected x, z or heading_deg",
             "room.json:2:53: found walkers[1].goal.heading_degrees, which has no effect; did you mean "
             "heading_deg?",
             "room.json:3:17: found constraints.speed, which has no effect; expected gait, min_speed_m_s, "
             "max_speed_m_s, latest_arrival_s or areas",
             "room.json:3:40: found constraints.areas[0].knd, which has no effect; did you mean kind?"}));
}

TEST(SceneNotes, leaveWhatUnknownMembersHoldAlone) {
  EXPECT_EQ(notesOf(R"({"author": {"name": "A", "name": "B", "start": {"heading": 1}}})"),
            Lines({"room.json:1:2: found author, which has no effect; expected " + kOuterNames}));
  EXPECT_EQ(notesOf(R"({"obstacles": [[{"heading": 1}]]})"), Lines());
  EXPECT_EQ(notesOf(R"([{"heading": 1}])"), Lines());
  EXPECT_EQ(notesOf("7"), Lines());
}

TEST(SceneNotes, countWhatIsWrongInTheSameWay) {
  std::string obstacles = R"({"colour": 1})";
  for (int i = 0; i < 999; ++i) obstacles += R"(, {"colour": 1})";
  const Lines lines = notesOf("{\"obstacles\": [" + obstacles + "]}");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("obstacles[0].colour"), std::string::npos);
  EXPECT_NE(lines[0].find("(and 999 more like it)"), std::string::npos);
}

TEST(SceneNotes, haveALimitOfNames) {
  std::string members = R"("a0": 0)";
  for (int i = 1; i < 200; ++i) members += ", \"a" + std::to_string(i) + "\": 0";
  const Lines lines = notesOf("{" + members + "}");
  ASSERT_EQ(lines.size(), kMostSceneNotes + 1);
  EXPECT_EQ(lines.back(), "room.json: found 150 more members that are not known or given twice");
}

TEST(SceneNotes, findPlacesOfNamesWithQuotationMarksAndBackslashes) {
  const Lines lines = notesOf(R"({ "a\\": 1, "b\"c\\\"": 2, "\u00e9": 3})");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].rfind("room.json:1:3: found a\\,", 0), 0U) << lines[0];
  EXPECT_EQ(lines[1].rfind("room.json:1:13: found b\"c\\\",", 0), 0U) << lines[1];
  EXPECT_EQ(lines[2].rfind("room.json:1:28: found \xc3\xa9,", 0), 0U) << lines[2];
}

TEST(SceneNotes, shortenLongNames) {
  const Lines lines = notesOf("{\"" + std::string(39, 'x') + "\xc3\xa9" + std::string(100, 'y') + "\": 1}");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("found " + std::string(39, 'x') + "..., which"), std::string::npos) << lines[0];
}

TEST(SceneMembers, areThoseThatTheReaderAsksFor) {
  EXPECT_TRUE(isKnownSceneMember("walkers"));
  EXPECT_FALSE(isKnownSceneMember("heading_deg"));
  EXPECT_EQ(findMember(SceneObject::kWalker, "goal")->holds, SceneObject::kPlacement);
  EXPECT_EQ(findMember(SceneObject::kNone, "x"), nullptr);
}

TEST(SceneNotes, keepUnknownMembersWhenTheSceneIsWrittenAgain) {
  const Result<Scene> scene = readSceneJson(caseText("misspelt_members.json"));
  ASSERT_TRUE(scene);
  EXPECT_NE(writeSceneJson(*scene).find(R"("constraint": {"gait":"run"})"), std::string::npos);
}

}  // namespace
}  // namespace stridegraph
