#include "scene/base64_url.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace stridegraph {
namespace {

std::string encoded(std::string_view text) {
  return toBase64Url(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64Url, writesTheVectorsOfRfc4648WithoutPadding) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg");
  EXPECT_EQ(encoded("fo"), "Zm8");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(toBase64Url(std::vector<std::uint8_t>{0xfb, 0xff}), "-_8");
}

TEST(Base64Url, readsBackWhatItWrote) {
  Random random(71);
  for (std::size_t size = 0; size < 100; ++size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    EXPECT_EQ(fromBase64Url(toBase64Url(bytes)), bytes);
  }
}

TEST(Base64Url, refusesForeignLettersLooseLettersAndStrayBits) {
  EXPECT_FALSE(fromBase64Url("Zm9v+"));
  EXPECT_FALSE(fromBase64Url("Zg=="));
  EXPECT_FALSE(fromBase64Url("Zm9vY"));
  EXPECT_FALSE(fromBase64Url("Zh"));
}

}  // namespace
}  // namespace stridegraph
