#include <gtest/gtest.h>

#include <array>

#include "base/utf8.h"
#include "math/random.h"
#include "motion/bvh_texts.h"
#include "motion/bvh_writer.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

void expectUtf8(const Warning& warning) {
  EXPECT_TRUE(isUtf8(warning.message));
  EXPECT_TRUE(isUtf8(warning.place.file));
}

/// Reads the bytes and looks at every string that comes of it. True when they are a clip.
bool readsAsUtf8(std::string_view bytes, std::string_view name) {
  const Result<BvhDocument> document = readBvh(bytes, name);
  if (!document) {
    expectUtf8({document.error().message, document.error().place});
    return false;
  }
  for (const Warning& warning : document->warnings) expectUtf8(warning);
  EXPECT_TRUE(isUtf8(document->clip.name));
  for (const Joint& joint : document->skeleton.joints) EXPECT_TRUE(isUtf8(joint.name));
  for (const std::string& endSite : document->layout.endSiteNames) EXPECT_TRUE(isUtf8(endSite));
  const std::string written = writeBvh(document->skeleton, document->layout, document->clip);
  EXPECT_TRUE(isUtf8(written));
  const BvhDocument back = testing::read(written, {document->layout.unitsPerMetre, document->layout.up});
  EXPECT_EQ(differenceBetween(document->skeleton, back.skeleton, 1e-3), "");
  return true;
}

std::string randomBytes(Random& random, std::size_t most) {
  std::string bytes(random.below(most + 1), '\0');
  for (char& c : bytes) c = static_cast<char>(random.below(256));
  return bytes;
}

TEST(RandomBvh, bytesAreRefusedInUtf8) {
  Random random(1);
  constexpr std::array beginnings = {""sv,         "HIERARCHY ROOT "sv, "\xFF\xFE"sv,
                                     "\xFE\xFF"sv, "\xEF\xBB\xBF"sv,    "HIERARCHY ROOT a\n{ OFFSET "sv};
  for (int i = 0; i < 20'000; ++i) {
    const std::string bytes =
        std::string(beginnings[random.below(beginnings.size())]) + randomBytes(random, 80);
    readsAsUtf8(bytes, randomBytes(random, 12));
  }
}

/// One random change: a byte, a piece left out, repeated or put in.
std::string mutated(std::string text, Random& random) {
  constexpr std::array pieces = {
      "\xE4"sv,    "\xC3\xA4"sv, "\xEF\xBB\xBF"sv, "\xC2\xA0"sv, "\x85"sv, "\xED\xA0"sv, "\0"sv,  "\x1A"sv,
      "{"sv,       "}"sv,        "\n"sv,           " "sv,        "-"sv,    "1 2 3"sv,    "nan"sv, "End"sv,
      "JOINT x"sv, ","sv,        "33.3333"sv,      "\t"sv};
  const std::size_t at = random.below(text.size());
  const std::size_t length = std::min(random.below(12) + 1, text.size() - at);
  switch (random.below(4)) {
    case 0:
      text[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(at, length));
      break;
    default:
      text.insert(at, pieces[random.below(pieces.size())]);
  }
  return text;
}

TEST(RandomBvh, mutatedClipsAreReadOrRefusedInUtf8) {
  Random random(2);
  std::vector<std::string> texts = {std::string(testing::kBodyText)};
  for (const char* const file : {"latin1_names.bvh", "end_sites_with_names.bvh", "utf16.bvh"}) {
    // The first rows are enough; the count of frames is wrong then, which is odd as well.
    texts.push_back(testing::contentOf(std::string(STRIDEGRAPH_TEST_DATA "/cases/") + file).substr(0, 6000));
  }
  int read = 0;
  int refused = 0;
  for (int i = 0; i < 4'000; ++i) {
    std::string bytes = texts[random.below(texts.size())];
    for (std::size_t changes = random.below(2) + 1; changes > 0; --changes) bytes = mutated(bytes, random);
    (readsAsUtf8(bytes, "H\xFC\x66te.bvh") ? read : refused) += 1;
  }
  EXPECT_GT(read, 300);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace stridegraph
