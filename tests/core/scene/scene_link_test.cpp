#include "scene/scene_link.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/hash.h"
#include "scene/base64_url.h"
#include "scene/scene_json.h"
#include "scene/test_scenes.h"

namespace stridegraph {
namespace {

SharedScene sharedHall() {
  Random random(60);
  SharedScene shared;
  shared.scene = randomScene(random);
  shared.search = "thesis";
  shared.libraryHash = 0x0123456789abcdefULL;
  return shared;
}

/// A link with these bytes and a checksum that holds.
std::string linkOf(std::vector<std::uint8_t> bytes) {
  const std::uint64_t hash = stableHash(bytes);
  const std::uint64_t folded = (hash ^ (hash >> 32U)) & 0xffffffffU;
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>(folded >> shift));
  return "s=" + toBase64Url(bytes);
}

std::vector<std::uint8_t> bodyOf(const std::string& link) {
  std::vector<std::uint8_t> bytes = *fromBase64Url(std::string_view(link).substr(2));
  bytes.resize(bytes.size() - 4);
  return bytes;
}

TEST(SceneLink, givesBackTheSceneItWasMadeFrom) {
  Random random(61);
  for (int i = 0; i < 200; ++i) {
    SharedScene shared;
    shared.scene = randomScene(random);
    shared.scene.goal.heading = Angle::radians(random.uniform(-4.0, 4.0));
    shared.libraryHash = random.bits();
    const Result<SharedScene> again = decodeLink(encodeLink(shared));
    ASSERT_TRUE(again) << again.error().message;
    expectSameScene(again->scene, shared.scene);
    EXPECT_EQ(again->search, "guided");
    EXPECT_EQ(again->libraryHash, shared.libraryHash);
  }
}

TEST(SceneLink, keepsScenesThatOldProgramsKnowInTheirVersion) {
  // "A small room": 6 m by 5 m, one wall, planned with library 0x1f, as version 1 wrote it.
  constexpr std::string_view kOld =
      "s=AQZndWlkZWQfAAAAAAAAAAxBIHNtYWxsIHJvb22A0w7AmgyAfQHAuALAuAIBgN3bAcCaDMC4AgABwKkH4NQDwD7AqQcAAGhpU7I";
  const Result<SharedScene> old = decodeLink(kOld);
  ASSERT_TRUE(old) << old.error().message;
  EXPECT_EQ(old->scene.name, "A small room");
  ASSERT_EQ(old->scene.obstacles.size(), 1U);
  EXPECT_EQ(old->scene.obstacles[0].size, Vec2(0.2, 3.0));
  EXPECT_TRUE(old->scene.walkers.empty());
  EXPECT_EQ(encodeLink(*old), kOld);
  SharedScene more = *old;
  more.scene.walkers.push_back({more.scene.goal, more.scene.start});
  EXPECT_EQ(bodyOf(encodeLink(more))[0], 2);
  more = *old;
  more.scene.constraints.gait = Gait::kWalk;
  EXPECT_EQ(bodyOf(encodeLink(more))[0], 2);
  EXPECT_EQ(decodeLink(encodeLink(more))->scene.constraints.gait, Gait::kWalk);
}

TEST(SceneLink, usesOnlyLettersThatAddressesAllowAndTakesAHash) {
  const std::string link = encodeLink(sharedHall());
  EXPECT_EQ(link.substr(0, 2), "s=");
  EXPECT_EQ(link.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_", 2),
            std::string::npos);
  ASSERT_TRUE(decodeLink("#" + link));
  EXPECT_EQ(decodeLink("#" + link)->search, "thesis");
}

TEST(SceneLink, staysShortForACityOfSixtyBlocks) {
  SharedScene shared;
  shared.scene.widthMetres = shared.scene.depthMetres = 60.0;
  Random random(62);
  for (int i = 0; i < 60; ++i) {
    const Vec2 centre = (randomPair(random, 2.0, 58.0) * 1e4).array().round() / 1e4;
    const Vec2 size = (randomPair(random, 3.0, 5.0) * 1e4).array().round() / 1e4;
    shared.scene.obstacles.push_back({centre, size});
  }
  EXPECT_LT(encodeLink(shared).size(), 1300U);
}

TEST(SceneLink, refusesEveryTruncation) {
  const std::string link = encodeLink(sharedHall());
  for (std::size_t length = 0; length < link.size(); ++length) {
    const Result<SharedScene> shared = decodeLink(std::string_view(link).substr(0, length));
    ASSERT_FALSE(shared) << length;
    EXPECT_EQ(shared.error().code, ErrorCode::kLinkDamaged);
  }
}

TEST(SceneLink, refusesEveryChangedLetter) {
  const std::string link = encodeLink(sharedHall());
  for (std::size_t i = 0; i < link.size(); ++i) {
    for (const char letter : {'A', 'x', '%'}) {
      std::string altered = link;
      if (altered[i] == letter) continue;
      altered[i] = letter;
      const Result<SharedScene> shared = decodeLink(altered);
      ASSERT_FALSE(shared) << i;
      EXPECT_EQ(shared.error().code, ErrorCode::kLinkDamaged);
    }
  }
}

TEST(SceneLink, saysInASentenceWhatIsWrong) {
  const auto message = [](std::string_view fragment) { return decodeLink(fragment).error().message; };
  const std::string tail = ", expected the whole link as it was copied";
  EXPECT_EQ(message("#room=3"), "the link is damaged: found no \"s=\" at its beginning" + tail);
  EXPECT_EQ(message("s=a b"), "the link is damaged: found letters that no link has" + tail);
  EXPECT_EQ(message("s=AQ"), "the link is damaged: found only its beginning" + tail);
  std::string altered = encodeLink(sharedHall());
  altered[5] = altered[5] == 'A' ? 'B' : 'A';
  EXPECT_EQ(message(altered), "the link is damaged: found a checksum that does not fit" + tail);
}

TEST(SceneLink, tellsANewerLinkFromABrokenOne) {
  std::vector<std::uint8_t> bytes = bodyOf(encodeLink(sharedHall()));
  bytes[0] = 3;
  const Result<SharedScene> shared = decodeLink(linkOf(bytes));
  ASSERT_FALSE(shared);
  EXPECT_EQ(shared.error().code, ErrorCode::kLinkVersion);
  EXPECT_EQ(shared.error().message,
            "the link was made by a newer program: found version 3, expected at most 2");
}

TEST(SceneLink, survivesForgedBytesBehindAGoodChecksum) {
  const std::vector<std::uint8_t> whole = bodyOf(encodeLink(sharedHall()));
  Random random(63);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> bytes = whole;
    for (std::uint64_t k = 0; k <= random.below(4); ++k) {
      bytes[1 + random.below(bytes.size() - 1)] = static_cast<std::uint8_t>(random.below(256));
    }
    if (random.below(3) == 0) bytes.resize(1 + random.below(bytes.size()));
    const Result<SharedScene> shared = decodeLink(linkOf(bytes));
    if (shared) {
      EXPECT_TRUE(checkScene(shared->scene));
    } else {
      EXPECT_EQ(shared.error().code, ErrorCode::kLinkDamaged);
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(SceneLink, refusesScenesThatBreakTheRules) {
  SharedScene shared = sharedHall();
  shared.scene.radiusMetres = 9.0;
  EXPECT_EQ(
      decodeLink(encodeLink(shared)).error().message,
      "the link is damaged: found radius: found 9, expected a number from 0.05 to 5, expected the whole link "
      "as it was copied");
  shared = sharedHall();
  shared.scene.unknownMembers = "[1]";
  EXPECT_FALSE(decodeLink(encodeLink(shared)));
}

TEST(SceneLink, refusesNamesThatAreNotUtf8) {
  SharedScene shared = sharedHall();
  shared.scene.name =
      "Gr\xfc\xdf"
      "e";
  EXPECT_EQ(decodeLink(encodeLink(shared)).error().message,
            "the link is damaged: found a name that is not UTF-8, expected the whole link as it was copied");
  shared = sharedHall();
  shared.search = "\xff";
  EXPECT_FALSE(decodeLink(encodeLink(shared)));
}

}  // namespace
}  // namespace stridegraph
