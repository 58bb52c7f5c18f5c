#include "motion/bvh_content.h"

#include <gtest/gtest.h>

#include <string>

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

/// "HIERARCHY" in characters of `width` bytes, with the byte that is not 0 at `place` of each.
std::string hierarchy(std::size_t width, std::size_t place) {
  std::string bytes;
  for (const char c : "\n\thierarchy"sv) {
    std::string character(width, '\0');
    character[place] = c;
    bytes += character;
  }
  return bytes;
}

TEST(BvhContent, tellsEncodingsByTheirMarks) {
  EXPECT_EQ(encodingOf("\xFF\xFEx"sv), BvhEncoding::kUtf16LittleEndian);
  EXPECT_EQ(encodingOf("\xFE\xFFx"sv), BvhEncoding::kUtf16BigEndian);
  EXPECT_EQ(encodingOf("\xFF\xFE\0\0"sv), BvhEncoding::kUtf32);
  EXPECT_EQ(encodingOf("\0\0\xFE\xFF"sv), BvhEncoding::kUtf32);
  EXPECT_EQ(encodingOf("\xEF\xBB\xBFHIERARCHY"sv), BvhEncoding::kBytes);
}

TEST(BvhContent, tellsEncodingsByTheFirstWord) {
  EXPECT_EQ(encodingOf(hierarchy(1, 0)), BvhEncoding::kBytes);
  EXPECT_EQ(encodingOf(hierarchy(2, 0)), BvhEncoding::kUtf16LittleEndian);
  EXPECT_EQ(encodingOf(hierarchy(2, 1)), BvhEncoding::kUtf16BigEndian);
  EXPECT_EQ(encodingOf(hierarchy(4, 0)), BvhEncoding::kUtf32);
  EXPECT_EQ(encodingOf(hierarchy(4, 3)), BvhEncoding::kUtf32);
  EXPECT_EQ(encodingOf("R\0O\0O\0T\0"sv), BvhEncoding::kBytes) << "another word does not tell";
  EXPECT_EQ(encodingOf(hierarchy(2, 0).substr(0, 8)), BvhEncoding::kBytes) << "cut off";
  EXPECT_EQ(encodingOf(""), BvhEncoding::kBytes);
}

TEST(BvhContent, namesOtherFilesByTheirBeginning) {
  EXPECT_EQ(otherContentIn("\x1F\x8B\x08"sv), "a gzip archive");
  EXPECT_EQ(otherContentIn(std::string(257, 'x') + "ustar"), "a tar archive");
  EXPECT_EQ(otherContentIn("\r\n\t<?xml"), "XML or HTML, such as a COLLADA file or a saved web page");
  EXPECT_EQ(otherContentIn("\x7F\x45LF\x02"sv), "a program");
}

TEST(BvhContent, namesNothingWhereABvhBegins) {
  for (const std::string_view text : {"HIERARCHY\nROOT a"sv, "  hierarchy"sv, "ROOT a"sv, ""sv, " \n"sv})
    EXPECT_EQ(otherContentIn(text), "");
}

}  // namespace
}  // namespace stridegraph
