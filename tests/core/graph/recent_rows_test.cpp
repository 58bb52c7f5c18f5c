#include "graph/recent_rows.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

TEST(RecentRows, giveBackTheLastRowsInTheirOrder) {
  RecentRows<int> rows;
  rows.restart(3, 2);
  for (int value = 1; value <= 7; ++value) {
    int* row = rows.push();
    row[0] = value;
    row[1] = -value;
    for (int back = 0; back < 3; ++back) {
      const int expected = value > back ? value - back : 0;
      EXPECT_EQ(rows.back(static_cast<std::size_t>(back))[0], expected);
      EXPECT_EQ(rows.back(static_cast<std::size_t>(back))[1], -expected);
    }
  }
}

TEST(RecentRows, areZeroAfterARestart) {
  RecentRows<int> rows;
  rows.restart(2, 3);
  rows.push()[2] = 5;
  rows.push()[0] = 6;
  rows.restart(4, 2);
  for (std::size_t back = 0; back < 4; ++back) {
    EXPECT_EQ(rows.back(back)[0], 0);
    EXPECT_EQ(rows.back(back)[1], 0);
  }
}

}  // namespace
}  // namespace stridegraph
