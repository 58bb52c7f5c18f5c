#include "scene/scene_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "math/random.h"
#include "scene/test_scenes.h"

namespace stridegraph {
namespace {

const std::string kValid = R"({"version": 1, "name": "Hall", "width": 20, "depth": 12,
 "obstacles": [{"x": 10, "z": 2.2, "width": 1, "depth": 7.4}, {"x": 4, "z": 9, "width": 2, "depth": 1}],
 "moving": [{"width": 1, "depth": 2, "repeat": "pingpong", "track": [{"t": 0, "x": 1, "z": 5}, {"t": 2.5, "x": 3, "z": 5}]}],
 "start": {"x": 3, "z": 3, "heading_deg": 90}, "goal": {"x": 17, "z": 3},
 "walkers": [{"start": {"x": 5, "z": 6}, "goal": {"x": 6, "z": 7, "heading_deg": 45}}],
 "constraints": {"gait": "run", "min_speed_m_s": 0.8, "max_speed_m_s": 1.6, "latest_arrival_s": 19.5,
  "areas": [{"x": 8, "z": 9, "width": 2.5, "depth": 3, "kind": "prefer"}]},
 "radius": 0.35, "seed": 18446744073709551615})";

/// The valid scene with one piece of its text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kValid;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  const Result<Scene> scene = readSceneJson(text);
  if (scene) return "accepted";
  EXPECT_EQ(scene.error().code, ErrorCode::kSceneValue);
  return scene.error().message;
}

TEST(SceneJson, readsEveryMember) {
  const Result<Scene> scene = readSceneJson(kValid);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->name, "Hall");
  EXPECT_EQ(scene->widthMetres, 20.0);
  EXPECT_EQ(scene->depthMetres, 12.0);
  ASSERT_EQ(scene->obstacles.size(), 2U);
  EXPECT_EQ(scene->obstacles[0].centre, Vec2(10.0, 2.2));
  EXPECT_EQ(scene->obstacles[0].size, Vec2(1.0, 7.4));
  ASSERT_EQ(scene->moving.size(), 1U);
  EXPECT_EQ(scene->moving[0].repeat, TrackRepeat::kPingPong);
  EXPECT_EQ(scene->moving[0].track[1].seconds, 2.5);
  EXPECT_EQ(scene->moving[0].track[1].position, Vec2(3.0, 5.0));
  EXPECT_EQ(scene->start.heading, Angle::degrees(90.0));
  EXPECT_EQ(scene->goal.heading, std::nullopt);
  ASSERT_EQ(scene->walkers.size(), 1U);
  EXPECT_EQ(scene->walkers[0].start.position, Vec2(5.0, 6.0));
  EXPECT_EQ(scene->walkers[0].start.heading, std::nullopt);
  EXPECT_EQ(scene->walkers[0].goal.position, Vec2(6.0, 7.0));
  EXPECT_EQ(scene->walkers[0].goal.heading, Angle::degrees(45.0));
  EXPECT_EQ(scene->constraints.gait, Gait::kRun);
  EXPECT_EQ(scene->constraints.minSpeedMetresPerSecond, 0.8);
  EXPECT_EQ(scene->constraints.maxSpeedMetresPerSecond, 1.6);
  EXPECT_EQ(scene->constraints.latestArrivalSeconds, 19.5);
  ASSERT_EQ(scene->constraints.areas.size(), 1U);
  expectSameRectangle(scene->constraints.areas[0].rectangle.centre,
                      scene->constraints.areas[0].rectangle.size, {{8.0, 9.0}, {2.5, 3.0}});
  EXPECT_EQ(scene->constraints.areas[0].kind, AreaKind::kPrefer);
  EXPECT_EQ(scene->radiusMetres, 0.35);
  EXPECT_EQ(scene->seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(scene->unknownMembers, "");
}

TEST(SceneJson, fillsInWhatMayBeMissing) {
  const Result<Scene> scene = readSceneJson(
      R"({"width": 5, "depth": 6, "obstacles": [], "start": {"x": 1, "z": 1}, "goal": {"x": 4, "z": 5}})");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->radiusMetres, 0.4);
  EXPECT_EQ(scene->seed, 1U);
  EXPECT_EQ(scene->name, "");
  EXPECT_TRUE(scene->walkers.empty());
  EXPECT_FALSE(scene->constraints.any());
}

TEST(SceneJson, namesMembersThatAreMissingOrOfTheWrongType) {
  EXPECT_EQ(refusal(changed(R"("width": 20, )", "")), "width: found nothing, expected a number");
  EXPECT_EQ(refusal(changed("20", "\"wide\"")), "width: found \"wide\", expected a number");
  EXPECT_EQ(refusal(changed(R"("x": 4, )", "")), "obstacles[1].x: found nothing, expected a number");
  EXPECT_EQ(refusal(changed(R"({"x": 17, "z": 3})", "[17, 3]")), "goal: found a list, expected an object");
  EXPECT_EQ(refusal(changed(R"("Hall")", "null")), "name: found null, expected a text");
  EXPECT_EQ(refusal(changed("18446744073709551615", "-1")),
            "seed: found -1, expected a whole number from 0 to 18446744073709551615");
  EXPECT_EQ(refusal(changed(R"("pingpong")", R"("pong")")),
            "moving[0].repeat: found \"pong\", expected \"loop\", \"pingpong\" or \"once\"");
  EXPECT_EQ(refusal(changed("90", "\"east\"")), "start.heading_deg: found \"east\", expected a number");
  EXPECT_EQ(refusal(changed(R"([{"t": 0, "x": 1, "z": 5}, {"t": 2.5, "x": 3, "z": 5}])", "7")),
            "moving[0].track: found 7, expected a list");
  EXPECT_EQ(refusal(changed(R"("start": {"x": 5, "z": 6}, )", "")),
            "walkers[0].start: found nothing, expected an object");
  EXPECT_EQ(refusal(changed(R"("heading_deg": 45)", R"("heading_deg": null)")),
            "walkers[0].goal.heading_deg: found null, expected a number");
  EXPECT_EQ(refusal(changed(R"("run")", R"("swim")")),
            "constraints.gait: found \"swim\", expected \"walk\" or \"run\"");
  EXPECT_EQ(refusal(changed(R"("latest_arrival_s": 19.5)", R"("latest_arrival_s": "soon")")),
            "constraints.latest_arrival_s: found \"soon\", expected a number");
  EXPECT_EQ(refusal(changed(R"(, "kind": "prefer")", "")),
            "constraints.areas[0].kind: found nothing, expected \"avoid\" or \"prefer\"");
  EXPECT_EQ(refusal("[1, 2]"), "scene: found a list, expected an object");
  EXPECT_EQ(refusal(changed(R"({"x": 4, "z": 9, "width": 2, "depth": 1})", "4")),
            "obstacles[1]: found 4, expected an object");
}

TEST(SceneJson, namesMembersOutOfRange) {
  EXPECT_EQ(refusal(changed("20", "0.5")), "width: found 0.5, expected a number from 1 to 1000");
  EXPECT_EQ(refusal(changed("12", "1001")), "depth: found 1001, expected a number from 1 to 1000");
  EXPECT_EQ(refusal(changed("7.4", "-1")), "obstacles[0].depth: found -1, expected a number above 0");
  EXPECT_EQ(refusal(changed(R"("width": 2,)", R"("width": 0,)")),
            "obstacles[1].width: found 0, expected a number above 0");
  EXPECT_EQ(refusal(changed("0.35", "0")), "radius: found 0, expected a number from 0.05 to 5");
  EXPECT_EQ(refusal(changed("0.8", "-0.1")),
            "constraints.min_speed_m_s: found -0.1, expected a number from 0 to 1.6");
  EXPECT_EQ(refusal(changed("0.8", "1.7")),
            "constraints.min_speed_m_s: found 1.7, expected a number from 0 to 1.6");
  EXPECT_EQ(refusal(changed("1.6", "10.5")),
            "constraints.max_speed_m_s: found 10.5, expected a number from 0 to 10");
  EXPECT_EQ(refusal(changed("19.5", "0")),
            "constraints.latest_arrival_s: found 0, expected a number above 0 and at most 3600");
  EXPECT_EQ(refusal(changed("19.5", "3601")),
            "constraints.latest_arrival_s: found 3601, expected a number above 0 and at most 3600");
  EXPECT_EQ(refusal(changed(R"("width": 2.5, "depth": 3)", R"("width": 2.5, "depth": 0)")),
            "constraints.areas[0].depth: found 0, expected a number above 0");
  EXPECT_EQ(refusal(changed(R"("t": 2.5)", R"("t": 0)")),
            "moving[0].track[1].t: found 0, expected a time above 0");
  EXPECT_EQ(refusal(changed(R"([{"t": 0, "x": 1, "z": 5}, {"t": 2.5, "x": 3, "z": 5}])", "[]")),
            "moving[0].track: found 0 elements, expected at least 1");
}

TEST(SceneJson, refusesVersionsItDoesNotKnow) {
  EXPECT_EQ(refusal(changed("\"version\": 1", "\"version\": 2")),
            "version: found 2, expected 1: the scene was made by a newer program");
  EXPECT_EQ(refusal(changed("\"version\": 1", "\"version\": \"1\"")), "version: found \"1\", expected 1");
  EXPECT_EQ(refusal(changed("\"version\": 1", "\"version\": 0")), "version: found 0, expected 1");
}

TEST(SceneJson, refusesMoreObstaclesThanAnyoneDraws) {
  std::string list = R"({"x": 1, "z": 1, "width": 1, "depth": 1})";
  std::string many = list;
  for (int i = 0; i < 10'000; ++i) many += "," + list;
  EXPECT_EQ(refusal(changed(R"({"x": 4, "z": 9, "width": 2, "depth": 1})", many)),
            "obstacles: found 10002 elements, expected at most 10000");
}

TEST(SceneJson, refusesMoreWalkersAndAreasThanItAllows) {
  const std::string walker = R"({"start": {"x": 5, "z": 6}, "goal": {"x": 6, "z": 7, "heading_deg": 45}})";
  std::string walkers = walker;
  for (int i = 0; i < 100; ++i) walkers += "," + walker;
  EXPECT_EQ(refusal(changed(walker, walkers)), "walkers: found 101 elements, expected at most 100");
  const std::string area = R"({"x": 8, "z": 9, "width": 2.5, "depth": 3, "kind": "prefer"})";
  std::string areas = area;
  for (int i = 0; i < 1000; ++i) areas += "," + area;
  EXPECT_EQ(refusal(changed(area, areas)), "constraints.areas: found 1001 elements, expected at most 1000");
}

TEST(SceneJson, writesWalkersAndConstraintsOnlyWhenThereAreSome) {
  Scene scene = *readSceneJson(kValid);
  EXPECT_NE(writeSceneJson(scene).find("\"walkers\""), std::string::npos);
  EXPECT_NE(writeSceneJson(scene).find("\"constraints\""), std::string::npos);
  scene.walkers.clear();
  scene.constraints = {};
  EXPECT_EQ(writeSceneJson(scene).find("\"walkers\""), std::string::npos);
  EXPECT_EQ(writeSceneJson(scene).find("\"constraints\""), std::string::npos);
}

TEST(SceneJson, pointsAtTheLineAndColumnOfBrokenText) {
  const Result<Scene> scene = readSceneJson("{\n  \"width\": 20,\n  \"depth\" 12\n}", "room.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::kSceneSyntax);
  EXPECT_EQ(describe(scene.error().place), "room.json:3:12");
  EXPECT_NE(scene.error().message.find("expected valid JSON"), std::string::npos);
  EXPECT_EQ(readSceneJson("{\"width\": 1e999}").error().code, ErrorCode::kSceneSyntax);
  EXPECT_EQ(readSceneJson("").error().code, ErrorCode::kSceneSyntax);
  EXPECT_EQ(readSceneJson("{\"name\": \"\xff\"}").error().code, ErrorCode::kSceneSyntax);
}

TEST(SceneJson, refusesEndlessNesting) {
  const Result<Scene> scene = readSceneJson(std::string(200'000, '['));
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message.find("64 levels of nesting"), std::string::npos);
}

TEST(SceneJson, keepsUnknownMembersInTheirOrder) {
  const std::string text =
      changed("\"seed\"", R"("zoom": 2.5, "author": {"name": "A", "tags": [1, null]}, "seed")");
  const Result<Scene> scene = readSceneJson(text);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->unknownMembers, R"({"zoom":2.5,"author":{"name":"A","tags":[1,null]}})");
  const Result<Scene> again = readSceneJson(writeSceneJson(*scene));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->unknownMembers, scene->unknownMembers);
}

TEST(SceneJson, leavesOutUnknownMembersThatWouldSpoilTheText) {
  Scene scene = *readSceneJson(kValid);
  scene.unknownMembers = "{\"a\": ";
  expectSameScene(*readSceneJson(writeSceneJson(scene)), *readSceneJson(kValid));
  scene.unknownMembers = R"({"width": 3})";
  EXPECT_EQ(readSceneJson(writeSceneJson(scene))->widthMetres, 20.0);
}

TEST(SceneJson, writesWhatItReadsBitForBit) {
  Random random(51);
  for (int i = 0; i < 200; ++i) {
    const Scene scene = randomScene(random);
    const Result<Scene> again = readSceneJson(writeSceneJson(scene));
    ASSERT_TRUE(again) << again.error().message;
    expectSameScene(*again, scene);
  }
}

TEST(SceneJson, writesShortNumbers) {
  Scene scene = *readSceneJson(kValid);
  scene.start.heading = Angle::degrees(33.3);
  const std::string text = writeSceneJson(scene);
  EXPECT_NE(text.find(R"("heading_deg": 33.3})"), std::string::npos) << text;
  EXPECT_NE(text.find(R"({"x": 10, "z": 2.2, "width": 1, "depth": 7.4})"), std::string::npos) << text;
}

TEST(SceneJson, staysWithinOneUnitForHeadingsNoDegreesGive) {
  Random random(52);
  for (int i = 0; i < 1000; ++i) {
    Scene scene = *readSceneJson(kValid);
    const double radians = random.uniform(-3.2, 3.2);
    scene.start.heading = Angle::radians(radians);
    const double again = readSceneJson(writeSceneJson(scene))->start.heading->radians();
    EXPECT_LE(std::abs(again - radians), std::abs(radians) * std::numeric_limits<double>::epsilon());
  }
}

TEST(SceneJson, refusesPlacesAndTimesThatNoRoomHas) {
  EXPECT_EQ(refusal(changed("\"x\": 17", "\"x\": 1e300")),
            "goal.x: found 1e+300, expected a number from -1000000 to 1000000");
  EXPECT_EQ(refusal(changed("7.4", "2e6")),
            "obstacles[0].depth: found 2000000, expected a number from 0 to 1000000");
  EXPECT_EQ(refusal(changed("2.5", "1e9")),
            "moving[0].track[1].t: found 1000000000, expected a number from -1000000 to 1000000");
  EXPECT_NE(refusal(changed("\"heading_deg\": 90", "\"heading_deg\": -1e9")).find("start.heading_deg"),
            std::string::npos);
}

TEST(SceneJson, checksScenesMadeInCode) {
  Scene scene = *readSceneJson(kValid);
  EXPECT_TRUE(checkScene(scene));
  scene.goal.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checkScene(scene).error().message, "goal.x: found nan, expected a finite number");
  EXPECT_FALSE(readSceneJson(writeSceneJson(scene)));
  scene = *readSceneJson(kValid);
  scene.walkers[0].goal.position.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(checkScene(scene).error().message, "walkers[0].goal.z: found inf, expected a finite number");
}

TEST(SceneJson, refusesPlacesSizesAndTimesBeyondAnyRoom) {
  const auto refused = [](const auto& change) {
    Scene scene = *readSceneJson(kValid);
    change(scene);
    const Result<void> checked = checkScene(scene);
    return checked ? std::string("taken") : checked.error().message;
  };
  EXPECT_EQ(refused([](Scene& scene) { scene.goal.position.x() = -1e300; }),
            "goal.x: found -1e+300, expected a number from -1000000 to 1000000");
  EXPECT_EQ(refused([](Scene& scene) { scene.obstacles[0].centre.y() = 1.1e6; }),
            "obstacles[0].z: found 1100000, expected a number from -1000000 to 1000000");
  EXPECT_EQ(refused([](Scene& scene) { scene.obstacles[0].size.x() = 1e18; }),
            "obstacles[0].width: found 1e+18, expected a number from 0 to 1000000");
  EXPECT_EQ(refused([](Scene& scene) { scene.moving[0].track[0].seconds = -1e9; }),
            "moving[0].track[0].t: found -1000000000, expected a number from -1000000 to 1000000");
  EXPECT_EQ(refused([](Scene& scene) { scene.start.position = {1e6, -1e6}; }), "taken");
}

TEST(SceneJson, readsEverySampleSceneAndWritesItAsItStands) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STRIDEGRAPH_SAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const Result<Scene> scene = readSceneJson(text.str(), entry.path().filename().string());
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(writeSceneJson(*scene), text.str());
    EXPECT_TRUE(scene->start.heading && scene->goal.heading) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 7);
}

}  // namespace
}  // namespace stridegraph
