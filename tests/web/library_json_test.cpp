#include "state/library_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace stridegraph {
namespace {

using nlohmann::json;

TEST(LibraryJson, tellsClipsAndNotes) {
  MotionLibrary library;
  library.frames.framesPerSecond = 30.0;
  library.clips = {{"walk.bvh", 0, 60, false}, {"walk.bvh", 60, 60, true}};
  library.license = "made for a test";
  library.hash = 0xabcU;
  library.notes = {{"61 rows, expected 60", {"walk.bvh", 119, 1}, WarningTopic::kRows}};
  const json told = json::parse(toJson(library));
  EXPECT_EQ(told["hash"], "0000000000000abc");
  EXPECT_EQ(told["license"], "made for a test");
  EXPECT_EQ(told["clips"][1], (json{{"name", "walk.bvh"}, {"frames", 60}, {"mirrored", true}}));
  EXPECT_EQ(told["notes"], json::parse(toJson(library.notes)));
  EXPECT_EQ(told["notes"][0]["topic"], "rows");
  EXPECT_EQ(told["notes"][0]["line"], 119);
}

TEST(LibraryJson, isValidWhateverBytesNamesHold) {
  MotionLibrary library;
  library.clips = {
      {"h\xfc"
       "fte",
       0, 60, false}};
  library.notes = {{"joint \"F\xdf\"", {"l\xe4uft.bvh"}}};
  const json told = json::parse(toJson(library), nullptr, false);
  ASSERT_FALSE(told.is_discarded());
  EXPECT_EQ(told["clips"][0]["name"], "h\uFFFDfte");
}

}  // namespace
}  // namespace stridegraph
