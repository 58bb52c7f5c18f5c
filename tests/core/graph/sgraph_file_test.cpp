#include "graph/sgraph_file.h"

#include <gtest/gtest.h>

#include "graph/graph_building.h"
#include "graph/library_checks.h"
#include "graph/test_library.h"
#include "math/random.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::threeWalks;

const MotionLibrary& sample() {
  static const MotionLibrary library = builtFrom(threeWalks()).library;
  return library;
}

void expectSameGraph(const MotionGraph& a, const MotionGraph& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.firstEdge, b.firstEdge);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t e = 0; e < a.edges.size(); ++e) {
    EXPECT_EQ(a.edges[e].from, b.edges[e].from);
    EXPECT_EQ(a.edges[e].to, b.edges[e].to);
    EXPECT_EQ(a.edges[e].kind, b.edges[e].kind);
    EXPECT_EQ(a.edges[e].frames, b.edges[e].frames);
    EXPECT_EQ(a.edges[e].sourceSpan, b.edges[e].sourceSpan);
    EXPECT_EQ(a.edges[e].targetSpan, b.edges[e].targetSpan);
    EXPECT_EQ(a.edges[e].distanceMetres, b.edges[e].distanceMetres);
  }
}

TEST(Sgraph, givesBackEveryPartOfALibraryExactly) {
  const MotionLibrary& library = sample();
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(differenceBetween(read->skeleton, library.skeleton, 0.0), "");
  EXPECT_EQ(read->layout.channels, library.layout.channels);
  EXPECT_EQ(read->layout.endSiteNames, library.layout.endSiteNames);
  EXPECT_EQ(read->layout.unitsPerMetre, library.layout.unitsPerMetre);
  EXPECT_EQ(read->layout.up, library.layout.up);
  EXPECT_EQ(read->frames.rootPositions, library.frames.rootPositions);
  ASSERT_EQ(read->frames.rotations.size(), library.frames.rotations.size());
  for (std::size_t k = 0; k < library.frames.rotations.size(); ++k)
    ASSERT_EQ(read->frames.rotations[k].coeffs(), library.frames.rotations[k].coeffs());
  ASSERT_EQ(read->clips.size(), library.clips.size());
  for (std::size_t c = 0; c < library.clips.size(); ++c) {
    EXPECT_EQ(read->clips[c].name, library.clips[c].name);
    EXPECT_EQ(read->clips[c].firstFrame, library.clips[c].firstFrame);
    EXPECT_EQ(read->clips[c].frameCount, library.clips[c].frameCount);
    EXPECT_EQ(read->clips[c].mirrored, library.clips[c].mirrored);
  }
  expectSameGraph(read->graph, library.graph);
  EXPECT_EQ(read->facingOffset.sin, library.facingOffset.sin);
  EXPECT_EQ(read->facingOffset.cos, library.facingOffset.cos);
  EXPECT_EQ(read->contactJoints, library.contactJoints);
  EXPECT_EQ(read->contacts, library.contacts);
  EXPECT_EQ(read->floorHeightMetres, library.floorHeightMetres);
  EXPECT_EQ(read->params.thresholdMetres, library.params.thresholdMetres);
  EXPECT_EQ(read->params.transitionFrames, library.params.transitionFrames);
  EXPECT_EQ(read->params.framesPerSecond, library.params.framesPerSecond);
  EXPECT_EQ(read->params.mirror, library.params.mirror);
  EXPECT_EQ(read->params.neighbourFrames, library.params.neighbourFrames);
  EXPECT_EQ(read->params.largestSpanRatio, library.params.largestSpanRatio);
  EXPECT_EQ(read->params.mostTransitions, library.params.mostTransitions);
  EXPECT_FALSE(library.regions.empty());
  EXPECT_EQ(read->regions, library.regions);
  EXPECT_EQ(read->license, library.license);
  EXPECT_EQ(read->hash, library.hash);
}

TEST(Sgraph, givesBackTheJointsThatStandStill) {
  MotionLibrary library = sample();
  library.layout.still.joints = {
      {{"reference", {}, Vec3(1, 0, 2)}, Quat(0.6, 0.0, 0.8, 0.0), {BvhChannel::kYRotation}, ""},
      {{"reference#end", JointIndex(std::size_t{0}), Vec3(0, 1, 0), true}, Quat::Identity(), {}, "tip"}};
  library.layout.still.before = 2;
  library.layout.still.holder = 0;
  library.layout.still.rootOffset = Vec3(0, 0.9, 0);
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read) << read.error().message;
  const BvhStillPart& still = read->layout.still;
  ASSERT_EQ(still.joints.size(), 2U);
  EXPECT_EQ(still.joints[0].joint.name, "reference");
  EXPECT_EQ(still.joints[0].joint.offset, Vec3(1, 0, 2));
  EXPECT_EQ(still.joints[0].rotation.coeffs(), Quat(0.6, 0.0, 0.8, 0.0).coeffs());
  EXPECT_EQ(still.joints[0].channels, std::vector<BvhChannel>{BvhChannel::kYRotation});
  EXPECT_EQ(still.joints[1].joint.parent, JointIndex(std::size_t{0}));
  EXPECT_TRUE(still.joints[1].joint.isEndSite);
  EXPECT_EQ(still.joints[1].endSiteName, "tip");
  EXPECT_EQ(still.before, 2U);
  EXPECT_EQ(still.rootOffset, Vec3(0, 0.9, 0));
  // Without them a file is as it was before there were any.
  library.layout.still = {};
  EXPECT_EQ(writeSgraph(library), writeSgraph(sample()));
  library.layout.still.joints = {{{"reference#end", {}, Vec3(0, 0, 0), true}, Quat::Identity(), {}, ""}};
  library.layout.still.before = 1;
  const Result<MotionLibrary> unsound = readSgraph(writeSgraph(library));
  ASSERT_FALSE(unsound);
  EXPECT_EQ(unsound.error().message, "the motion library is not sound: a still root that is an end site");
}

TEST(Sgraph, isTheSameBytesForTheSameLibrary) {
  const std::vector<std::uint8_t> bytes = writeSgraph(sample());
  EXPECT_EQ(writeSgraph(*readSgraph(bytes)), bytes);
  EXPECT_EQ(sgraphHash(sample()), sample().hash);
}

TEST(Sgraph, loadsFromAnyAddress) {
  std::vector<std::uint8_t> shifted = {0};
  const std::vector<std::uint8_t> bytes = writeSgraph(sample());
  shifted.insert(shifted.end(), bytes.begin(), bytes.end());
  EXPECT_TRUE(readSgraph(std::span<const std::uint8_t>(shifted).subspan(1)));
}

TEST(Sgraph, refusesEveryFlippedByte) {
  std::vector<std::uint8_t> bytes = writeSgraph(sample());
  Random random(31);
  // The head with its tables byte by byte, the bulk of numbers here and there.
  for (std::size_t k = 0; k < bytes.size();
       k += k < 1024 || k + 1024 > bytes.size() ? 1 : 1 + random.below(800)) {
    const auto flip = static_cast<std::uint8_t>(1 + random.below(255));
    bytes[k] = static_cast<std::uint8_t>(bytes[k] ^ flip);
    const Result<MotionLibrary> read = readSgraph(bytes);
    ASSERT_FALSE(read) << "byte " << k;
    EXPECT_TRUE(read.error().code == ErrorCode::kAssetDamaged ||
                read.error().code == ErrorCode::kAssetVersion);
    bytes[k] = static_cast<std::uint8_t>(bytes[k] ^ flip);
  }
  EXPECT_TRUE(readSgraph(bytes));
}

TEST(Sgraph, refusesTruncatedAndLengthenedFiles) {
  std::vector<std::uint8_t> bytes = writeSgraph(sample());
  Random random(32);
  for (int i = 0; i < 100; ++i)
    EXPECT_FALSE(readSgraph(std::span<const std::uint8_t>(bytes).first(random.below(bytes.size()))));
  bytes.push_back(0);
  EXPECT_FALSE(readSgraph(bytes));
}

TEST(Sgraph, saysWhatAForeignFileLacks) {
  EXPECT_EQ(readSgraph({}).error().message, "0 bytes are too few for a motion library (.sgraph)");
  EXPECT_EQ(readSgraph(std::vector<std::uint8_t>(100, 7)).error().message,
            "this is no motion library: the mark SGRF is missing");
}

/// The refusal of a library that was written with a right hash, but is not sound.
std::string refusalOf(const MotionLibrary& library) {
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  return read ? "" : read.error().message;
}

TEST(Sgraph, refusesLibrariesThatAreNotSound) {
  const std::string start = "the motion library is not sound: ";
  MotionLibrary library = sample();
  library.graph.edges[0].frames += 1;
  EXPECT_TRUE(refusalOf(library).starts_with(start + "the edge from frame ")) << refusalOf(library);
  library = sample();
  library.graph.nodes[0] = FrameIndex(std::size_t{100'000});
  EXPECT_EQ(refusalOf(library), start + "node 0 out of range or order");
  library = sample();
  library.frames.rotations[0].w() = 3.0;
  EXPECT_EQ(refusalOf(library), start + "the rotation of joint hips in frame 0 is not of unit length");
  library = sample();
  library.clips[1].frameCount += 1;
  EXPECT_EQ(refusalOf(library), start + "clips of 241 frames for a library of 240");
  library = sample();
  library.contacts[5] = 255;
  EXPECT_EQ(refusalOf(library), start + "contact mask 255 for 4 contact joints");
  library = sample();
  library.facingOffset.sin = 2.0;
  EXPECT_EQ(refusalOf(library), start + "a facing offset that is no unit vector");
  library = sample();
  library.skeleton.joints[3].parent = JointIndex(std::size_t{9});
  EXPECT_EQ(refusalOf(library), start + "joint leftFoot comes before its parent");
  library = sample();
  library.params.transitionFrames = 0;
  EXPECT_EQ(refusalOf(library), start + "transitions of 0 frames, 2 to 120 expected");
  library = sample();
  library.regions.back().columnSpan = 300;
  EXPECT_EQ(refusalOf(library),
            start + "region " + std::to_string(library.regions.size() - 1) + " out of range");
  library = sample();
  std::swap(library.regions[0], library.regions[1]);
  EXPECT_EQ(refusalOf(library), start + "region 1 out of order");
  library = sample();
  library.regions[0].distanceMetres = -1.0F;
  EXPECT_EQ(refusalOf(library), start + "region 0 has no sound distance");
  library = sample();
  library.graph = {};
  EXPECT_EQ(refusalOf(library), start + "an empty graph");
}

TEST(Sgraph, refusesLengthsThatNoBodyHas) {
  const std::string start = "the motion library is not sound: ";
  MotionLibrary library = sample();
  library.skeleton.joints[3].offset.y() = -1e30;
  EXPECT_EQ(refusalOf(library), start + "the offset of joint leftFoot is more than 1000000 m");
  library = sample();
  library.frames.rootPositions[5].z() = 1e30;
  EXPECT_EQ(refusalOf(library), start + "the root's position in frame 5 is more than 1000000 m");
}

TEST(Sgraph, givesNamesAsUtf8WhateverWroteTheFile) {
  MotionLibrary library = sample();
  library.license = "gemessen f\xfcr alle";
  library.skeleton.joints[3].name = "linker_Fu\xdf";
  library.clips[0].name = "vorw\xe4rts";
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->license, "gemessen f\xc3\xbcr alle");
  EXPECT_EQ(read->skeleton.joints[3].name, "linker_Fu\xc3\x9f");
  EXPECT_EQ(read->clips[0].name, "vorw\xc3\xa4rts");
}

TEST(Sgraph, refusesGraphsWithDeadEnds) {
  MotionLibrary library = sample();
  library.graph.nodes.push_back(FrameIndex(std::size_t{239}));
  MotionEdge out;
  out.from = NodeIndex(library.graph.nodes.size() - 2);
  out.to = NodeIndex(library.graph.nodes.size() - 1);
  out.frames = 239 - library.graph.nodes[out.from.value].value;
  library.graph.edges.push_back(out);
  indexEdges(library.graph);
  EXPECT_EQ(refusalOf(library), "the motion library is not sound: a graph with dead ends");
}

}  // namespace
}  // namespace stridegraph
