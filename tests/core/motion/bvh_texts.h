#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "motion/bvh_reader.h"

namespace stridegraph::testing {

/// Somebody 1.7 m tall in centimetres: hips at 90 cm, a chest 50 cm above them with a head 30 cm higher, one
/// leg down to the floor with a foot of 20 cm. Two frames, 1 cm along x apart.
inline constexpr std::string_view kBodyText =
    "HIERARCHY\n"
    "ROOT hips\n"
    "{\n"
    "\tOFFSET 0 0 0\n"
    "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "\tJOINT chest\n"
    "\t{\n"
    "\t\tOFFSET 0 50 0\n"
    "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "\t\tEnd Site\n"
    "\t\t{\n"
    "\t\t\tOFFSET 0 30 0\n"
    "\t\t}\n"
    "\t}\n"
    "\tJOINT leg\n"
    "\t{\n"
    "\t\tOFFSET 0 -90 0\n"
    "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "\t\tEnd Site\n"
    "\t\t{\n"
    "\t\t\tOFFSET 0 0 20\n"
    "\t\t}\n"
    "\t}\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.0333333\n"
    "0 90 0 10 20 30 40 50 60 70 80 85\n"
    "1 90 0 10 20 30 40 50 60 70 80 85\n";

/// `text` with the first `from`, which must be there, replaced.
inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const std::size_t at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) result.replace(at, from.size(), to);
  return result;
}

/// `text` with every `from` replaced.
inline std::string replacedAll(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  for (std::size_t at = 0; (at = result.find(from, at)) != std::string::npos; at += to.size()) {
    result.replace(at, from.size(), to);
  }
  return result;
}

/// The document of a text that must be readable.
inline BvhDocument read(std::string_view text, const BvhReadParams& params = {}) {
  Result<BvhDocument> document = readBvh(text, "body.bvh", params);
  EXPECT_TRUE(document) << describe(document.error());
  return document ? std::move(*document) : BvhDocument{};
}

/// "file:line:column: message" of a text that must be refused.
inline std::string refusal(std::string_view text, const BvhReadParams& params = {}) {
  const Result<BvhDocument> document = readBvh(text, "body.bvh", params);
  return document ? "read without complaint" : describe(document.error());
}

/// All warnings, a line each.
inline std::string warningsOf(const BvhDocument& document) {
  std::string text;
  for (const Warning& warning : document.warnings) text += describe(warning) + "\n";
  return text;
}

/// The greatest distance, in metres, between equal joints of two clips at equal frames.
double greatestDistance(const BvhDocument& a, const BvhDocument& b);
/// The greatest angle, in degrees, between equal joints' rotations at equal frames.
double greatestAngleDegrees(const Clip& a, const Clip& b);

}  // namespace stridegraph::testing
