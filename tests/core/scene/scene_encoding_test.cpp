#include "scene/scene_encoding.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "base/utf8.h"
#include "scene/scene_json.h"
#include "scene/scene_limits.h"

namespace stridegraph {
namespace {

using namespace std::string_literals;

const std::string kScene =
    R"({"name": "Saal", "width": 5, "depth": 6, "obstacles": [], "start": {"x": 1, "z": 1}, "goal": {"x": 4, "z": 5}})";

std::string refusal(const std::string& bytes) {
  const Result<Scene> scene = readSceneJson(bytes, "room.json");
  if (scene) return "accepted";
  EXPECT_EQ(scene.error().code, ErrorCode::kSceneSyntax);
  return describe(scene.error());
}

/// Every letter as `size` bytes, the letter itself at `place`.
std::string wide(const std::string& text, std::size_t size, std::size_t place) {
  std::string bytes;
  for (const char letter : text) {
    std::string unit(size, '\0');
    unit[place] = letter;
    bytes += unit;
  }
  return bytes;
}

TEST(SceneEncoding, takesUtf8WithAndWithoutByteOrderMark) {
  EXPECT_EQ(refusal(kScene), "accepted");
  EXPECT_EQ(refusal("\xef\xbb\xbf" + kScene), "accepted");
}

TEST(SceneEncoding, namesWideEncodings) {
  const std::string utf16 = "room.json: found text in UTF-16, expected UTF-8";
  EXPECT_EQ(refusal("\xff\xfe" + wide(kScene, 2, 0)), utf16);
  EXPECT_EQ(refusal("\xfe\xff" + wide(kScene, 2, 1)), utf16);
  EXPECT_EQ(refusal(wide(kScene, 2, 0)), utf16) << "no byte-order mark";
  EXPECT_EQ(refusal(wide(kScene, 2, 1)), utf16);
  const std::string utf32 = "room.json: found text in UTF-32, expected UTF-8";
  EXPECT_EQ(refusal("\xff\xfe\0\0"s + wide(kScene, 4, 0)), utf32);
  EXPECT_EQ(refusal("\0\0\xfe\xff"s + wide(kScene, 4, 3)), utf32);
  EXPECT_EQ(refusal(wide(kScene, 4, 0)), utf32);
  EXPECT_EQ(refusal(wide(kScene, 4, 3)), utf32);
}

TEST(SceneEncoding, pointsAtTheFirstByteThatIsNotUtf8) {
  EXPECT_EQ(refusal("{\n \"name\": \"S\xc3\xa4le, B\xfcro\"}"),
            "room.json:2:19: found the byte 0xFC, expected text in UTF-8");
  EXPECT_EQ(refusal("\x80"), "room.json:1:1: found the byte 0x80, expected text in UTF-8");
  EXPECT_EQ(refusal(kScene + "\n\xe2\x82"), "room.json:2:1: found the byte 0xE2, expected text in UTF-8");
}

TEST(SceneEncoding, refusesLargeTextsUnread) {
  EXPECT_EQ(refusal(std::string(kMostSceneBytes + 1, ' ')),
            "room.json: found 16777217 bytes, expected a scene of at most 16777216");
  EXPECT_EQ(refusal(kScene + std::string(kMostSceneBytes - kScene.size(), ' ')), "accepted");
}

TEST(SceneEncoding, keepsNamesInAnyScript) {
  std::ifstream file(std::string(STRIDEGRAPH_CASES) + "/names_not_latin.json", std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const Result<Scene> scene = readSceneJson(text);
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_NE(text.find("\"" + scene->name + "\""), std::string::npos);
  EXPECT_GT(scene->name.size(), 10U);
  EXPECT_TRUE(isUtf8(scene->name));
  EXPECT_EQ(readSceneJson(writeSceneJson(*scene))->name, scene->name);
}

TEST(SceneJson, refusesObjectsOfMoreMembersThanItAllows) {
  std::string members = "\"a0\": 0";
  for (std::size_t i = 1; i <= kMostJsonMembers; ++i) members += ", \"a" + std::to_string(i) + "\": 0";
  EXPECT_EQ(refusal("{" + members + "}"),
            "room.json: found an object of more than 256 members, expected a scene");
}

}  // namespace
}  // namespace stridegraph
