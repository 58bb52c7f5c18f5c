#include "motion/bvh_text.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "motion/bvh_texts.h"

namespace stridegraph {
namespace {

using namespace std::string_view_literals;
using testing::kBodyText;
using testing::read;
using testing::refusal;
using testing::replaced;
using testing::replacedAll;
using testing::warningsOf;

/// ASCII in characters of `width` bytes, with the byte that is not 0 at `place` of each.
std::string widened(std::string_view ascii, std::size_t width, std::size_t place) {
  std::string bytes;
  for (const char c : ascii) {
    std::string character(width, '\0');
    character[place] = c;
    bytes += character;
  }
  return bytes;
}

void expectBody(std::string_view bytes, std::string_view warnings) {
  const BvhDocument document = read(bytes);
  EXPECT_EQ(warningsOf(document), warnings);
  EXPECT_EQ(differenceBetween(read(kBodyText).skeleton, document.skeleton), "");
  EXPECT_EQ(document.clip.rootPositions, read(kBodyText).clip.rootPositions);
  for (const Warning& warning : document.warnings) EXPECT_EQ(warning.topic, WarningTopic::kText);
}

TEST(BvhText, borrowsPlainText) {
  const auto text = decodeBvhText(kBodyText, "body.bvh");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->view().data(), kBodyText.data());
  EXPECT_EQ(text->view().size(), kBodyText.size());
  EXPECT_TRUE(text->warnings.empty());
}

TEST(BvhText, keepsItsTextWhenItMoves) {
  auto text = decodeBvhText("\xFC", "short.bvh");
  ASSERT_TRUE(text);
  const BvhText moved = std::move(*text);
  EXPECT_EQ(moved.view(), "\xC3\xBC");
}

TEST(BvhText, takesUtf8WithAndWithoutMark) {
  expectBody("\xEF\xBB\xBF" + std::string(kBodyText), "");
  const BvhDocument body = read(replaced(kBodyText, "leg", "\xE8\x85\xBF"));
  EXPECT_EQ(body.skeleton.joints[3].name, "\xE8\x85\xBF");
  EXPECT_EQ(warningsOf(body), "");
}

TEST(BvhText, takesUtf16WithMark) {
  expectBody("\xFF\xFE" + widened(kBodyText, 2, 0), "");
  expectBody("\xFE\xFF" + widened(kBodyText, 2, 1), "");
}

TEST(BvhText, takesUtf16WithoutMarkAndSaysSo) {
  const std::string text = " \r\n" + std::string(kBodyText);
  expectBody(widened(text, 2, 0),
             "body.bvh: read the text as UTF-16 (little-endian), though it has no byte-order mark\n");
  expectBody(widened(replaced(text, "HIERARCHY", "Hierarchy"), 2, 1),
             "body.bvh: read the text as UTF-16 (big-endian), though it has no byte-order mark\n");
}

TEST(BvhText, takesOddUtf16AndSaysSo) {
  std::string text = "\xFF\xFE" + widened(kBodyText, 2, 0) + "\n";
  expectBody(text, "body.bvh: left out the last byte, which is half of a UTF-16 character\n");
  text = "\xFF\xFE" + widened(replaced(kBodyText, "leg", "~"), 2, 0);
  text.replace(text.find('~'), 2, "\x3D\xD8");
  const BvhDocument lone = read(text);
  EXPECT_EQ(lone.skeleton.joints[3].name, "\xEF\xBF\xBD");
  EXPECT_EQ(warningsOf(lone),
            "body.bvh: read UTF-16 surrogates without their other half (1 in all) as U+FFFD\n");
  // Two marks: the second is a blank, and the text is the decoder's own.
  expectBody("\xFF\xFE\xFF\xFE" + widened(kBodyText, 2, 0),
             "body.bvh:1:1: found 1 odd blank or control character (U+FEFF) and read it as a blank\n");
}

TEST(BvhText, readsOtherLinesAsWindows1252AndNamesThem) {
  std::string text = replaced(kBodyText, "ROOT hips", "ROOT H\xFC\x66te");
  text = replaced(replaced(text, "chest", "Brust \x80 {\n"), "\n\n\t{", "\n");
  text = replaced(text, "JOINT leg", "JOINT \xE8\x85\xBF");
  const BvhDocument body = read(text);
  EXPECT_EQ(body.skeleton.joints[0].name, "H\xC3\xBC\x66te");
  EXPECT_EQ(body.skeleton.joints[1].name, "Brust \xE2\x82\xAC");
  EXPECT_EQ(body.skeleton.joints[3].name, "\xE8\x85\xBF") << "UTF-8 among other lines";
  EXPECT_EQ(warningsOf(body),
            "body.bvh:2: found text that is not UTF-8 and read it as Windows-1252: \"H\xC3\xBC\x66te\" "
            "(line 2), \"Brust \xE2\x82\xAC\" (line 6)\n");
  EXPECT_EQ(body.warnings[0].topic, WarningTopic::kText);
}

TEST(BvhText, namesSixLinesAtMostAndShortensThem) {
  std::string text = "HIERARCHY";
  for (int i = 0; i < 9; ++i) text += "\nJOINT " + std::string(50, '\xE4');
  const auto decoded = decodeBvhText(text, "a.bvh");
  ASSERT_TRUE(decoded);
  ASSERT_EQ(decoded->warnings.size(), 1U);
  const std::string& message = decoded->warnings[0].message;
  EXPECT_NE(
      message.find(replacedAll(std::string(40, 'x'), "x", "\xC3\xA4") + "...\" (line 7) and 3 more lines"),
      std::string::npos)
      << message;
  EXPECT_EQ(message.find("line 8"), std::string::npos);
}

TEST(BvhText, countsLinesAndColumnsOfTheFile) {
  const std::string broken = replaced(kBodyText, "\tJOINT leg", "\tJOINT b\xE4r { x");
  EXPECT_EQ(refusal(broken), "body.bvh:15:14: found \"x\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  const std::string utf8 = replaced(broken, "\xE4", "\xC3\xA4");
  EXPECT_EQ(refusal("\xEF\xBB\xBF" + replacedAll(utf8, "\n", "\r\n")),
            "body.bvh:15:14: found \"x\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  std::string wide = "\xFE\xFF" + widened(broken, 2, 1);
  EXPECT_EQ(refusal(wide), "body.bvh:15:14: found \"x\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  EXPECT_EQ(refusal("\xEF\xBB\xBF  x"), "body.bvh:1:3: found \"x\", expected HIERARCHY");
  EXPECT_EQ(refusal("\xEF\xBB\xBF\xEF\xBB\xBF\xC2\xA0x"), "body.bvh:1:3: found \"x\", expected HIERARCHY");
}

TEST(BvhText, readsBlanksBeyondAsciiAsBlanks) {
  std::string text = replaced(kBodyText, "\tOFFSET 0 0 0", "\xC2\xA0\xE3\x80\x80OFFSET 0\xC2\xA0\x30 0");
  text = replaced(text, "JOINT leg", "JOINT\xC2\xA0left\xE2\x80\xAFleg\xEF\xBB\xBF");
  const BvhDocument body = read(text);
  EXPECT_EQ(body.skeleton.joints[3].name, "left leg");
  EXPECT_EQ(
      warningsOf(body),
      "body.bvh:4:1: found 6 odd blanks or control characters (U+00A0, U+3000, U+202F, U+FEFF) and read "
      "them as blanks\n");
}

TEST(BvhText, readsControlCharactersAsBlanks) {
  const BvhDocument body = read(replaced(kBodyText, "leg", "left\x01leg\x7F"));
  EXPECT_EQ(body.skeleton.joints[3].name, "left leg");
  EXPECT_EQ(warningsOf(body),
            "body.bvh:15:12: found 2 odd blanks or control characters (U+0001, U+007F) and read them as "
            "blanks\n");
  // Bytes that Windows-1252 leaves undefined become control characters of Latin-1.
  EXPECT_EQ(read(replaced(kBodyText, "leg", "left\x81leg")).skeleton.joints[3].name, "left leg");
  EXPECT_EQ(refusal(replaced(kBodyText, "leg", "\x01\x02")),
            "body.bvh:16:2: found \"{\", expected a joint's name");
}

TEST(BvhText, readsTabsInNamesAsSpaces) {
  EXPECT_EQ(read(replaced(kBodyText, "leg", "left\tleg\t")).skeleton.joints[3].name, "left leg");
}

TEST(BvhText, leavesOutPaddingBehindTheText) {
  expectBody(std::string(kBodyText) + "\x1A",
             "body.bvh: left out 1 byte of 0 or Ctrl-Z at the end of the file\n");
  expectBody(std::string(kBodyText) + std::string(512, '\0'),
             "body.bvh: left out 512 bytes of 0 or Ctrl-Z at the end of the file\n");
}

std::string refusalOfContent(std::string_view found) {
  return "body.bvh: found " + std::string(found) + ", expected a BVH text, which begins with HIERARCHY";
}

TEST(BvhText, namesWhatElseAFileSeemsToBe) {
  const std::array<std::pair<std::string_view, std::string_view>, 14> kinds = {{
      {"\x1F\x8B\x08\0\0\0\0\0"sv, "a gzip archive"},
      {"PK\x03\x04\x14\0\0\0"sv, "a ZIP archive"},
      {"Kaydara FBX Binary  \0\x1A\0"sv, "a binary FBX file"},
      {"glTF\x02\0\0\0"sv, "a GLB file"},
      {"\x02\x50\x1E\0"sv, "a C3D file"},
      {"\x20\0\0\0SGRF\0\0"sv, "a library of this program (.sgraph)"},
      {"\n {\"version\": 1}"sv, "JSON, such as a scene or a glTF file"},
      {"\xEF\xBB\xBF{}"sv, "JSON, such as a scene or a glTF file"},
      {"<!DOCTYPE html>"sv, "XML or HTML, such as a COLLADA file or a saved web page"},
      {"; FBX 7.4.0 project file"sv, "an FBX file"},
      {"version https://git-lfs.github.com/spec/v1\n"sv, "a Git LFS pointer in place of the file"},
      {":version 1.10\n:name VICON\n"sv, "an Acclaim skeleton (ASF)"},
      {"#!OML:ASF F:\\VICON\\"sv, "an Acclaim motion (AMC)"},
      {"PathFileType\t4\t(X/Y/Z)"sv, "a table of markers (TRC)"},
  }};
  for (const auto& [bytes, name] : kinds)
    EXPECT_EQ(refusal(bytes), refusalOfContent("what seems to be " + std::string(name)));
  EXPECT_EQ(
      refusal("\xFF\xFE" + widened("<a/>", 2, 0)),
      refusalOfContent("what seems to be XML or HTML, such as a COLLADA file or a saved web page in UTF-16"));
}

TEST(BvhText, refusesWhatIsNoText) {
  EXPECT_EQ(refusal(""), refusalOfContent("an empty file"));
  EXPECT_EQ(refusal("\xEF\xBB\xBF"), refusalOfContent("an empty file"));
  EXPECT_EQ(refusal("\xFF\xFE"), refusalOfContent("an empty file"));
  EXPECT_EQ(refusal("\0\0\0"sv), refusalOfContent("bytes of 0 alone"));
  EXPECT_EQ(refusal("a\0b"sv), refusalOfContent("bytes of 0 as in binary files, but no text"));
  EXPECT_EQ(refusal("a\x01z"), refusalOfContent("control characters as in binary files, but no text"));
  std::string zero(kBodyText);
  zero[zero.find("leg")] = '\0';
  EXPECT_EQ(refusal(zero), refusalOfContent("bytes of 0 as in binary files, but no text"));
  for (const std::string& utf32 :
       {"\xFF\xFE" + std::string(2, '\0') + widened(kBodyText, 4, 0), widened(kBodyText, 4, 0),
        std::string(2, '\0') + "\xFE\xFF" + widened(kBodyText, 4, 3), widened(kBodyText, 4, 3)}) {
    EXPECT_EQ(refusal(utf32), refusalOfContent("text in UTF-32, which is not read"));
  }
}

TEST(BvhText, makesFileNamesUtf8) {
  const auto refused = readBvh("{", "H\xFC\x66te.bvh");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place.file, "H\xC3\xBC\x66te.bvh");
  const auto document = readBvh(kBodyText, "H\xFC\x66te.bvh");
  ASSERT_TRUE(document);
  EXPECT_EQ(document->clip.name, "H\xC3\xBC\x66te.bvh");
}

}  // namespace
}  // namespace stridegraph
