#include "state/walk_marks.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

PlanReport arrived() {
  PlanReport report;
  report.status = PlanStatus::kArrived;
  report.jointSpeed = {1.25, 40, "knee"};
  report.jointAcceleration = {1.72, 90, "ankle"};
  report.seams = {{10, {}, {}, 0.012}, {60, {}, {}, 0.034}, {95, {}, {}, 0.020}};
  return report;
}

TEST(WalkMarks, pointAtTheWorstJointsAndTheWidestSeam) {
  const std::vector<WalkMark> marks = walkMarks(arrived());
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_EQ(marks[0].frame, 40U);
  EXPECT_EQ(marks[1].frame, 90U);
  EXPECT_EQ(marks[2].frame, 60U);
  EXPECT_EQ(marks[2].value, "3.4 cm");
  EXPECT_NE(marks[1].where.find("Frame 90: joint ankle"), std::string::npos);
}

TEST(WalkMarks, callAProblemWhatCapturesDoNotDo) {
  const std::vector<WalkMark> marks = walkMarks(arrived());
  EXPECT_FALSE(marks[0].problem);
  EXPECT_TRUE(marks[1].problem);
}

TEST(WalkMarks, areNoneWithoutAWalkAndNameNoSeamWhereThereIsNone) {
  PlanReport report = arrived();
  report.seams.clear();
  EXPECT_EQ(walkMarks(report).size(), 2U);
  report.status = PlanStatus::kNoPath;
  EXPECT_TRUE(walkMarks(report).empty());
}

}  // namespace
}  // namespace stridegraph
