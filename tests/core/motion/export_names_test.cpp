#include "motion/export_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/utf8.h"
#include "math/random.h"

namespace stridegraph {
namespace {

TEST(ExportName, keepsNamesThatAnyFileHolds) {
  EXPECT_EQ(exportName("Left Hand", "joint"), "Left Hand");
  EXPECT_EQ(exportName("m\xC3\xBChle \xE6\x89\x8B", "joint"), "m\xC3\xBChle \xE6\x89\x8B");
}

TEST(ExportName, replacesControlCharactersAndTrimsBlanks) {
  EXPECT_EQ(exportName(" \ta\nb\x01\x7F", "joint"), "a_b__");
  EXPECT_EQ(exportName("a\xC2\x85"
                       "b",
                       "joint"),
            "a_b");
  EXPECT_EQ(exportName(std::string_view("a\0b", 3), "joint"), "a_b");
}

TEST(ExportName, takesTheFallbackForNothing) {
  EXPECT_EQ(exportName("", "joint"), "joint");
  EXPECT_EQ(exportName(" \r\n", "joint"), "joint");
}

TEST(ExportName, makesUtf8OfAnyBytes) {
  Random random(3);
  for (int sample = 0; sample < 2000; ++sample) {
    std::string bytes;
    for (int i = 0; i < 12; ++i)
      bytes.push_back(static_cast<char>(static_cast<int>(random.uniform(0.0, 256.0))));
    const std::string name = exportName(bytes, "joint");
    EXPECT_TRUE(isUtf8(name));
    EXPECT_FALSE(name.empty());
    EXPECT_TRUE(std::none_of(name.begin(), name.end(),
                             [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7F'; }));
  }
}

TEST(MadeUnique, numbersEqualNamesAroundThoseThatAreTaken) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(madeUnique({"a", "b", "a", "a"}), (Names{"a", "b", "a_2", "a_3"}));
  EXPECT_EQ(madeUnique({"a", "a", "a_2"}), (Names{"a", "a_3", "a_2"}));
  EXPECT_EQ(madeUnique({"a", "a_2", "a", "a_2"}), (Names{"a", "a_2", "a_3", "a_2_2"}));
  EXPECT_EQ(madeUnique({}), Names{});
}

TEST(MadeUnique, leavesNoTwoAlike) {
  Random random(4);
  const std::vector<std::string> parts = {"a", "_2", "_3", "b", "_2_2"};
  for (int sample = 0; sample < 500; ++sample) {
    std::vector<std::string> names;
    for (int i = 0; i < 30; ++i) {
      std::string name;
      for (int k = 0; k < 3; ++k) name += parts[static_cast<std::size_t>(random.uniform(0.0, 5.0))];
      names.push_back(name);
    }
    const std::vector<std::string> unique = madeUnique(names);
    EXPECT_EQ(std::set<std::string>(unique.begin(), unique.end()).size(), names.size());
    EXPECT_EQ(unique, madeUnique(unique));
  }
}

}  // namespace
}  // namespace stridegraph
