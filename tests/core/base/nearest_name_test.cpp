#include "base/nearest_name.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace stridegraph {
namespace {

constexpr std::array<std::string_view, 6> kCommands = {"build", "info", "plan", "gait", "figures", "bench"};

std::string nearest(std::string_view found) {
  return std::string(nearestName(found, kCommands).value_or("nothing"));
}

TEST(NearestName, findsWhatIsOneSlipAway) {
  EXPECT_EQ(nearest("paln"), "plan") << "swapped";
  EXPECT_EQ(nearest("buld"), "build") << "left out";
  EXPECT_EQ(nearest("innfo"), "info") << "inserted";
  EXPECT_EQ(nearest("benck"), "bench") << "replaced";
  EXPECT_EQ(nearest("plan"), "plan");
}

TEST(NearestName, takesABeginningForTheWholeAndTheWholeForABeginning) {
  constexpr std::array<std::string_view, 3> kMembers = {"x", "z", "heading_deg"};
  EXPECT_EQ(nearestName("heading", kMembers), "heading_deg");
  EXPECT_EQ(nearest("fig"), "figures");
  EXPECT_EQ(nearest("planning"), "plan");
}

TEST(NearestName, suggestsNothingForOtherWords) {
  EXPECT_EQ(nearest("retarget"), "nothing");
  EXPECT_EQ(nearest("walk"), "nothing");
  EXPECT_EQ(nearest(""), "nothing");
  EXPECT_EQ(nearest(std::string(100'000, 'p')), "nothing");
  EXPECT_EQ(nearestName("plan", {}), std::nullopt);
  constexpr std::array<std::string_view, 2> kShort = {"x", "z"};
  EXPECT_EQ(nearestName("y", kShort), std::nullopt) << "nothing in common";
}

TEST(NearestName, takesTheFirstOfEquallyNearNames) {
  constexpr std::array<std::string_view, 2> kNames = {"minim", "maxim"};
  EXPECT_EQ(nearestName("mnxim", kNames), "maxim");
  constexpr std::array<std::string_view, 2> kBoth = {"abcd", "abce"};
  EXPECT_EQ(nearestName("abcf", kBoth), "abcd");
}

}  // namespace
}  // namespace stridegraph
