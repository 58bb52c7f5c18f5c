#include "graph/stages.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace stridegraph {
namespace {

struct Work {
  std::vector<double> shares;  ///< Returned one after the other.
  std::size_t calls = 0;
  StageRow<Work>* ends = nullptr;

  double next() { return shares[calls++]; }
  double last() {
    ++calls;
    if (ends != nullptr) ends->end();
    return 1.0;
  }
};

constexpr std::array<Stage<Work>, 2> kStages = {{{0.75, &Work::next}, {0.25, &Work::last}}};

TEST(StageRow, goesThroughItsStagesPieceByPiece) {
  Work work{{0.5, 1.0}};
  StageRow<Work> row(kStages);
  EXPECT_EQ(row.progress(), 0.0);
  EXPECT_TRUE(row.step(work));
  EXPECT_DOUBLE_EQ(row.progress(), 0.375);
  EXPECT_TRUE(row.step(work));
  EXPECT_DOUBLE_EQ(row.progress(), 0.75);
  EXPECT_FALSE(row.step(work));
  EXPECT_TRUE(row.isDone());
  EXPECT_EQ(row.progress(), 1.0);
  EXPECT_FALSE(row.step(work));
  EXPECT_EQ(work.calls, 3U);
}

TEST(StageRow, neverFallsBackWhateverAStageTells) {
  Work work{{0.6, 0.2, -1.0, 7.0}};
  StageRow<Work> row(kStages);
  double progress = row.progress();
  while (row.step(work)) {
    EXPECT_GE(row.progress(), progress);
    progress = row.progress();
  }
  EXPECT_EQ(row.progress(), 1.0);
}

TEST(StageRow, leavesOutWhatFollowsWhenAStageEndsIt) {
  constexpr std::array<Stage<Work>, 2> kEndedByFirst = {{{0.5, &Work::last}, {0.5, &Work::next}}};
  Work work{{}};
  StageRow<Work> row(kEndedByFirst);
  work.ends = &row;
  EXPECT_FALSE(row.step(work));
  EXPECT_EQ(row.progress(), 1.0);
  EXPECT_EQ(work.calls, 1U);
}

}  // namespace
}  // namespace stridegraph
