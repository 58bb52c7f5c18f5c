#include <gtest/gtest.h>

#include "motion/bvh_reader.h"
#include "motion/bvh_texts.h"

namespace stridegraph {
namespace {

using testing::kBodyText;
using testing::refusal;
using testing::replaced;

TEST(RefuseBvh, namesTheMissingSections) {
  EXPECT_EQ(refusal(" \n"), "body.bvh:2:1: found the end of the text, expected HIERARCHY");
  EXPECT_EQ(refusal(replaced(kBodyText, "HIERARCHY\n", "")),
            "body.bvh:1:1: found \"ROOT\", expected HIERARCHY");
  EXPECT_EQ(refusal(replaced(kBodyText, "HIERARCHY", "HIERARCHY2")),
            "body.bvh:1:1: found \"HIERARCHY2\", expected HIERARCHY");
  EXPECT_EQ(refusal(replaced(kBodyText, "ROOT hips", "JOINT hips")),
            "body.bvh:2:1: found \"JOINT\", expected ROOT");
  EXPECT_EQ(refusal(replaced(kBodyText, "MOTION\n", "")),
            "body.bvh:25:1: found \"Frames:\", expected MOTION");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2\n", "")),
            "body.bvh:26:1: found \"Frame\", expected \"Frames:\"");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames 2")),
            "body.bvh:26:8: found \"2\", expected \"Frames:\"");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frame Time: 0.0333333\n", "")),
            "body.bvh:27:1: found \"0\", expected \"Frame Time:\"");
}

TEST(RefuseBvh, findsUnbalancedBraces) {
  EXPECT_EQ(refusal(replaced(kBodyText, "}\nMOTION", "}\n}\nMOTION")),
            "body.bvh:25:1: found \"}\", expected MOTION");
  EXPECT_EQ(refusal(replaced(kBodyText, "\t}\n}\nMOTION", "\t}\nMOTION")),
            "body.bvh:24:1: found \"MOTION\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  EXPECT_EQ(refusal(kBodyText.substr(0, kBodyText.find("\t}\n}\nMOTION"))),
            "body.bvh:23:1: found the end of the text, expected } to close \"leg\" of line 15");
  EXPECT_EQ(refusal(replaced(kBodyText, "hips\n{", "hips\n")), "body.bvh:4:2: found \"OFFSET\", expected {");
}

TEST(RefuseBvh, namesWhatABlockMayHold) {
  EXPECT_EQ(refusal(replaced(kBodyText, "JOINT leg", "LIMB leg")),
            "body.bvh:15:2: found \"LIMB\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  EXPECT_EQ(refusal(replaced(kBodyText, "\t\t\tOFFSET 0 30 0", "\t\t\tJOINT toe")),
            "body.bvh:12:4: found \"JOINT\", expected OFFSET or }");
  EXPECT_EQ(refusal(replaced(kBodyText, "End Site", "Ends here")),
            "body.bvh:10:3: found \"Ends\", expected OFFSET, CHANNELS, JOINT, End Site or }");
  EXPECT_EQ(refusal(replaced(kBodyText, "JOINT leg\n", "JOINT\n")),
            "body.bvh:16:2: found \"{\", expected a joint's name");
  EXPECT_EQ(refusal(replaced(kBodyText, "\t\t\tOFFSET 0 30 0\n", "")),
            "body.bvh:13:2: found } without an OFFSET for \"chest#end\" of line 10, expected OFFSET");
  EXPECT_EQ(refusal(replaced(kBodyText, "OFFSET 0 50 0", "OFFSET 0 50 0 OFFSET 0 50 0")),
            "body.bvh:8:24: found OFFSET for a second time in the block of \"chest\", expected one OFFSET "
            "before the "
            "children");
  EXPECT_EQ(refusal(replaced(kBodyText, "\t}\n}\nMOTION",
                             "\t}\n\tCHANNELS 3 Xrotation Yrotation Zrotation\n}\nMOTION")),
            "body.bvh:24:11: found CHANNELS for a second time in the block of \"hips\", expected one "
            "CHANNELS before "
            "the children");
  EXPECT_EQ(
      refusal(replaced(replaced(kBodyText, "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n", ""),
                       "\t\t}\n\t}\n", "\t\t}\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n\t}\n")),
      "body.bvh:13:12: found CHANNELS behind the children of \"chest\", expected one CHANNELS before the "
      "children");
}

TEST(RefuseBvh, checksChannels) {
  EXPECT_EQ(refusal(replaced(kBodyText, "CHANNELS 6", "CHANNELS 7")),
            "body.bvh:5:11: found 7 channels, expected 0 to 6");
  EXPECT_EQ(refusal(replaced(kBodyText, "CHANNELS 6", "CHANNELS many")),
            "body.bvh:5:11: found \"many\", expected the number of channels");
  EXPECT_EQ(refusal(replaced(kBodyText, "Xposition", "Xscale")),
            "body.bvh:5:13: found \"Xscale\", expected 6 channels such as Xposition or Zrotation");
  EXPECT_EQ(refusal(replaced(kBodyText, "Yposition", "Xposition")),
            "body.bvh:5:23: found a channel of \"hips\" for the second time, expected each once");
  EXPECT_EQ(refusal(replaced(kBodyText, "CHANNELS 3 Zrotation Xrotation Yrotation",
                             "CHANNELS 3 Zrotation Xrotation")),
            "body.bvh:10:3: found \"End\", expected 3 channels such as Xposition or Zrotation");
  EXPECT_EQ(refusal("HIERARCHY ROOT a\n{ OFFSET 0 0 0 } MOTION"),
            "body.bvh:2:18: found \"MOTION\", expected a joint with CHANNELS before the end of HIERARCHY");
}

TEST(RefuseBvh, findsWhatIsNotANumber) {
  EXPECT_EQ(refusal(replaced(kBodyText, "OFFSET 0 50 0", "OFFSET 0 fifty 0")),
            "body.bvh:8:12: found \"fifty\", expected three numbers after OFFSET");
  EXPECT_EQ(refusal(replaced(kBodyText, "OFFSET 0 50 0", "OFFSET 0 50")),
            "body.bvh:9:3: found \"CHANNELS\", expected three numbers after OFFSET");
  EXPECT_EQ(
      refusal(replaced(kBodyText, "1 90 0", "1 9,5 0")),
      "body.bvh:29:3: found \"9,5\", expected a channel's value, with a decimal point, and blanks between "
      "numbers");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 0x5A 0")),
            "body.bvh:29:3: found \"0x5A\", expected a channel's value");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 -- 0")),
            "body.bvh:29:3: found \"--\", expected a channel's value");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 +-9 0")),
            "body.bvh:29:3: found \"+-9\", expected a channel's value");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 1.#QNAN 0")),
            "body.bvh:29:3: found \"1.#QNAN\", expected a channel's value");
}

TEST(RefuseBvh, findsNumbersThatAreNotFiniteOrFarTooLarge) {
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 nan 0")),
            "body.bvh:29:3: found \"nan\", expected a channel's value, finite and at most 1e9 in size");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 -INF 0")),
            "body.bvh:29:3: found \"-INF\", expected a channel's value, finite and at most 1e9 in size");
  EXPECT_EQ(refusal(replaced(kBodyText, "OFFSET 0 50 0", "OFFSET 0 infinity 0")),
            "body.bvh:8:12: found \"infinity\", expected three numbers after OFFSET, finite and at most 1e9 "
            "in size");
  EXPECT_EQ(refusal(replaced(kBodyText, "1 90 0", "1 1e999 0")),
            "body.bvh:29:3: found \"1e999\", expected a channel's value, finite and at most 1e9 in size");
  EXPECT_EQ(
      refusal(replaced(kBodyText, "1 90 0", "1 1000000001 0")),
      "body.bvh:29:3: found \"1000000001\", expected a channel's value, finite and at most 1e9 in size");
}

TEST(RefuseBvh, namesThePlaceOfAFrameTime) {
  EXPECT_EQ(
      refusal(replaced(kBodyText, "0.0333333", "0")),
      "body.bvh:27:13: found a frame time of 0, expected the seconds from one frame to the next, 0.0001 "
      "to 1");
  EXPECT_EQ(refusal(replaced(kBodyText, "0.0333333", "fast")),
            "body.bvh:27:13: found \"fast\", expected the frame time in seconds");
}

TEST(RefuseBvh, checksTheFrameCount) {
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames: 0")),
            "body.bvh:26:9: found 0 frames, expected at least 1");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames: -1")),
            "body.bvh:26:9: found \"-1\", expected the number of frames");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames: 2.5")),
            "body.bvh:26:9: found \"2.5\", expected the number of frames");
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames: 999999999")),
            "body.bvh:26:9: found 999999999 frames, expected at most 1000000");
  EXPECT_EQ(
      refusal(replaced(kBodyText, "Frames: 2", "Frames: 18446744073709551617")),
      "body.bvh:26:9: found \"18446744073709551617\", expected the number of frames of at most 9 digits");
  const std::string empty(kBodyText.substr(0, kBodyText.find("0 90 0")));
  EXPECT_EQ(refusal(empty),
            "body.bvh:28:1: found the end of the text, expected a row of 12 numbers, of which 0 are there");
  EXPECT_EQ(refusal(empty + "0 90 0"),
            "body.bvh:28:7: found the end of the text, expected a row of 12 numbers, of which 3 are there");
}

TEST(RefuseBvh, countsColumnsInCharacters) {
  EXPECT_EQ(refusal(replaced(kBodyText, "JOINT leg\n\t{", "JOINT b\xC3\xA4r { x")),
            "body.bvh:15:14: found \"x\", expected OFFSET, CHANNELS, JOINT, End Site or }");
}

TEST(RefuseBvh, checksTheForcedUnit) {
  BvhReadParams params;
  params.unitsPerMetre = 0.0;
  EXPECT_EQ(refusal(kBodyText, params), "found 0 units per metre, expected a number from 1e-6 to 1e9");
}

}  // namespace
}  // namespace stridegraph
