#include "figures/png.h"

#include <gtest/gtest.h>

namespace stridegraph::figures {
namespace {

std::string base64Of(std::string_view text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// The test vectors of RFC 4648, section 10.
TEST(Base64, padsToWholeGroups) {
  EXPECT_EQ(base64Of(""), "");
  EXPECT_EQ(base64Of("f"), "Zg==");
  EXPECT_EQ(base64Of("fo"), "Zm8=");
  EXPECT_EQ(base64Of("foo"), "Zm9v");
  EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
}

TEST(Base64, usesThePlainAlphabet) {
  const std::uint8_t bytes[] = {0xfb, 0xff, 0xfe};
  EXPECT_EQ(base64(bytes), "+//+");
}

TEST(PngDataUri, beginsWithThePngSignature) {
  const std::string uri = pngDataUri({2, 1, 3, {255, 0, 0, 0, 0, 255}});
  EXPECT_TRUE(uri.starts_with("data:image/png;base64,iVBORw0KGgo")) << uri;
}

}  // namespace
}  // namespace stridegraph::figures
