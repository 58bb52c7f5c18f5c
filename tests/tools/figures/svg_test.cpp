#include "figures/svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "figures/axes.h"

namespace stridegraph::figures {
namespace {

TEST(EscapeXml, replacesWhatXmlGivesAMeaning) {
  EXPECT_EQ(escapeXml("a < b && \"c\" > d"), "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
}

TEST(EscapeXml, keepsLettersBeyondAsciiAndDropsControlCharacters) {
  EXPECT_EQ(escapeXml("3\u00b0\x01 \x1f|\n"), "3\u00b0 |\n");
}

TEST(Pixels, areAsShortAsATenthAllows) {
  EXPECT_EQ(pixels(12.0), "12");
  EXPECT_EQ(pixels(12.04), "12");
  EXPECT_EQ(pixels(12.06), "12.1");
  EXPECT_EQ(pixels(-0.26), "-0.3");
  EXPECT_EQ(pixels(-0.04), "0");
}

TEST(Svg, escapesTitlesAndTexts) {
  Svg svg(100.0, 50.0, "A & B");
  svg.text({10.0, 20.0}, "x < y");
  const std::string text = svg.finish();
  EXPECT_NE(text.find("<title>A &amp; B</title>"), std::string::npos);
  EXPECT_NE(text.find(">x &lt; y</text>"), std::string::npos);
}

TEST(Svg, knowsWhatItsShapesCover) {
  Svg svg(200.0, 100.0, "");
  svg.line({20.0, 30.0}, {60.0, 40.0}, {.stroke = "#000000", .strokePixels = 2.0});
  svg.circle({100.0, 50.0}, 10.0, {.fill = "#000000"});
  EXPECT_DOUBLE_EQ(svg.drawn().left, 19.0);
  EXPECT_DOUBLE_EQ(svg.drawn().top, 29.0);
  EXPECT_DOUBLE_EQ(svg.drawn().right, 110.0);
  EXPECT_DOUBLE_EQ(svg.drawn().bottom, 60.0);
}

TEST(Svg, countsOnlyWhatAClipLeaves) {
  Svg svg(200.0, 100.0, "");
  svg.beginClip({50.0, 20.0, 80.0, 60.0});
  svg.circle({80.0, 40.0}, 10.0, {.fill = "#000000"});
  svg.circle({300.0, 40.0}, 10.0, {.fill = "#000000"});
  svg.endClip();
  EXPECT_DOUBLE_EQ(svg.drawn().right, 80.0);
  svg.circle({150.0, 40.0}, 10.0, {.fill = "#000000"});
  EXPECT_DOUBLE_EQ(svg.drawn().right, 160.0);
}

TEST(Svg, notesWhereTextsStandByTheirAnchor) {
  Svg svg(200.0, 100.0, "");
  svg.text({100.0, 50.0}, "middle", {10.0, Anchor::kMiddle});
  svg.text({100.0, 50.0}, "end", {10.0, Anchor::kEnd});
  svg.text({100.0, 50.0}, "upright", {10.0, Anchor::kMiddle, "#000000", false, true});
  ASSERT_EQ(svg.labels().size(), 3U);
  EXPECT_DOUBLE_EQ(svg.labels()[0].box.left + svg.labels()[0].box.right, 200.0);
  EXPECT_DOUBLE_EQ(svg.labels()[1].box.right, 100.0);
  EXPECT_DOUBLE_EQ(svg.labels()[2].box.top + svg.labels()[2].box.bottom, 100.0);
  EXPECT_GT(svg.labels()[2].box.height(), svg.labels()[2].box.width());
}

TEST(Svg, leavesOutLinesOfASinglePoint) {
  Svg svg(200.0, 100.0, "");
  const Vec2 alone[] = {{10.0, 10.0}};
  svg.polyline(alone, {.stroke = "#000000"});
  EXPECT_EQ(svg.finish().find("polyline"), std::string::npos);
}

TEST(RoundTicks, areRoundAndWithinTheRange) {
  EXPECT_EQ(roundTicks(0.0, 10.0, 6), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
  EXPECT_EQ(roundTicks(-1.1, 1.2, 3), (std::vector<double>{-1.0, 0.0, 1.0}));
  EXPECT_EQ(roundTicks(7.0, 0.0, 4), (std::vector<double>{0.0, 2.0, 4.0, 6.0}));
}

TEST(RoundTicks, areNeverMoreThanAskedFor) {
  for (std::size_t most = 2; most < 20; ++most) {
    for (const double high : {0.013, 0.9, 1.0, 3.7, 42.0, 999.0}) {
      const std::vector<double> ticks = roundTicks(0.0, high, most);
      EXPECT_LE(ticks.size(), most) << high;
      EXPECT_FALSE(std::signbit(ticks.front()));
      EXPECT_LE(ticks.back(), high * (1.0 + 1e-9));
    }
  }
}

TEST(Axes, placeValuesInTheirFrame) {
  const Axes upwards({10.0, 20.0, 110.0, 70.0}, {0.0, 10.0, "x (m)"}, {0.0, 5.0, "y (m)"});
  EXPECT_EQ(upwards.at(0.0, 0.0), Vec2(10.0, 70.0));
  EXPECT_EQ(upwards.at(10.0, 5.0), Vec2(110.0, 20.0));
  const Axes downwards({10.0, 20.0, 110.0, 70.0}, {0.0, 10.0, "x (m)"}, {5.0, 0.0, "z (m)"});
  EXPECT_EQ(downwards.at(0.0, 0.0), Vec2(10.0, 20.0));
}

}  // namespace
}  // namespace stridegraph::figures
