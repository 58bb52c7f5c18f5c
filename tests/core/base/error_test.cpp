#include "base/error.h"

#include <gtest/gtest.h>

#include <set>

namespace stridegraph {
namespace {

TEST(Error, describeNamesThePlaceAsFileLineColumn) {
  const Error error{ErrorCode::kBvhValue, "found 'x', expected a number", {"walk.bvh", 12, 7}};
  EXPECT_EQ(describe(error), "walk.bvh:12:7: found 'x', expected a number");
}

TEST(Error, describeLeavesOutWhatIsUnknown) {
  EXPECT_EQ(describe(Error{ErrorCode::kFile, "cannot be read", {"a.bvh"}}), "a.bvh: cannot be read");
  EXPECT_EQ(describe(Error{ErrorCode::kFile, "cannot be read"}), "cannot be read");
}

TEST(ErrorCode, everyCodeHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const ErrorCode code : kAllErrorCodes) names.insert(errorCodeName(code));
  EXPECT_EQ(names.size(), kAllErrorCodes.size());
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(WarningTopic, everyTopicHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const WarningTopic topic : kAllWarningTopics) names.insert(warningTopicName(topic));
  EXPECT_EQ(names.size(), kAllWarningTopics.size());
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace stridegraph
