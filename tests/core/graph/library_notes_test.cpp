#include "graph/library_notes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/utf8.h"
#include "graph/library_checks.h"
#include "graph/library_limits.h"
#include "graph/sgraph_file.h"
#include "graph/test_library.h"
#include "math/random.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::documentOf;
using testing::threeWalks;
using testing::walkOf;

const MotionLibrary& sample() {
  static const MotionLibrary library = builtFrom(threeWalks()).library;
  return library;
}

std::vector<std::string> textsOf(const Warnings& notes) {
  std::vector<std::string> texts;
  for (const Warning& note : notes)
    texts.push_back(fmt::format("{} [{}]", describe(note), warningTopicName(note.topic)));
  return texts;
}

std::string randomBytes(Random& random) {
  std::string bytes;
  for (std::size_t k = random.below(40); k > 0; --k) bytes.push_back(static_cast<char>(random.below(256)));
  return bytes;
}

TEST(LibraryNotes, comeBackFromAFileAsTheyWere) {
  MotionLibrary library = sample();
  library.notes = {{"two rows more than declared", {"walk.bvh", 12, 7}, WarningTopic::kRows},
                   {"nothing stands", {}, WarningTopic::kGraph}};
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(textsOf(read->notes),
            (std::vector<std::string>{"walk.bvh:12:7: two rows more than declared [rows]",
                                      "nothing stands [graph]"}));
}

TEST(LibraryNotes, leaveTheHashOfALibraryAsItIs) {
  MotionLibrary library = sample();
  library.notes.clear();
  const std::uint64_t hash = sgraphHash(library);
  const std::vector<std::uint8_t> bare = writeSgraph(library);
  library.notes = {{"odd", {"walk.bvh"}, WarningTopic::kUnit}};
  EXPECT_EQ(sgraphHash(library), hash);
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->hash, hash);
  library.notes.clear();
  EXPECT_EQ(writeSgraph(library), bare);
  EXPECT_TRUE(readSgraph(bare)->notes.empty());
}

TEST(LibraryNotes, areCoveredByAHashOfTheirOwn) {
  MotionLibrary library = sample();
  library.notes = {{"odd", {"walk.bvh"}, WarningTopic::kUnit}};
  std::vector<std::uint8_t> bytes = writeSgraph(library);
  Random random(3);
  for (std::size_t k = 0; k < bytes.size();
       k += k < 1024 || k + 1024 > bytes.size() ? 1 : 1 + random.below(800)) {
    const auto flip = static_cast<std::uint8_t>(1 + random.below(255));
    bytes[k] = static_cast<std::uint8_t>(bytes[k] ^ flip);
    ASSERT_FALSE(readSgraph(bytes)) << "byte " << k;
    bytes[k] = static_cast<std::uint8_t>(bytes[k] ^ flip);
  }
  EXPECT_TRUE(readSgraph(bytes));
}

TEST(LibraryNotes, areWrittenWithinTheirLimits) {
  MotionLibrary library = sample();
  library.notes.clear();
  for (int k = 0; k < 700; ++k)
    library.notes.push_back({fmt::format("note {}", k), {}, WarningTopic::kOther});
  // A character of two bytes lies across the limit.
  library.notes[0].message = "x";
  for (std::size_t k = 0; k < kMostNoteBytes; ++k) library.notes[0].message += "é";
  const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->notes.size(), kMostLibraryNotes);
  EXPECT_EQ(read->notes.back().message, "201 further notes are not kept: a library holds 500 at most");
  EXPECT_LE(read->notes[0].message.size(), kMostNoteBytes);
  EXPECT_GT(read->notes[0].message.size(), kMostNoteBytes - 8);
  EXPECT_TRUE(isUtf8(read->notes[0].message));
  EXPECT_TRUE(read->notes[0].message.ends_with("é..."));
}

TEST(LibraryNotes, areCheckedInALibrary) {
  MotionLibrary library = sample();
  library.notes.assign(kMostLibraryNotes + 1, {"same", {}, WarningTopic::kOther});
  EXPECT_EQ(faultIn(library), "501 notes, at most 500 expected");
  library.notes = {{std::string(kMostNoteBytes + 1, 'x'), {}, WarningTopic::kOther}};
  EXPECT_EQ(faultIn(library), "note 0 of 2001 bytes, at most 2000 expected");
  library.notes = {{"caf\xe9", {}, WarningTopic::kOther}};
  EXPECT_EQ(faultIn(library), "note 0 is not UTF-8");
  library.notes = {{"same", {"caf\xe9"}, WarningTopic::kOther}};
  EXPECT_EQ(faultIn(library), "note 0 is not UTF-8");
}

TEST(LibraryNotes, areNamedOnce) {
  const Warning note{"odd", {"walk.bvh", 3}, WarningTopic::kRows};
  EXPECT_EQ(keepableNotes({note, note, note}).size(), 1U);
  Warning elsewhere = note;
  elsewhere.place.line = 4;
  EXPECT_EQ(keepableNotes({note, elsewhere, note}).size(), 2U);
}

TEST(LibraryNotes, areWhatTheBuildWarnedOf) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].warnings = {{"one row more than declared", {"left.bvh", 9}, WarningTopic::kRows}};
  for (Vec3& root : documents[2].clip.rootPositions) root.y() += 0.03;
  const BuiltLibrary built = builtFrom(std::move(documents));
  EXPECT_EQ(textsOf(built.library.notes), textsOf(built.report.warnings));
  ASSERT_GE(built.library.notes.size(), 2U);
  EXPECT_EQ(textsOf(built.library.notes)[0], "left.bvh:9: one row more than declared [rows]");
  EXPECT_EQ(built.library.notes[1].topic, WarningTopic::kMotion);
  EXPECT_EQ(built.library.hash, sgraphHash(built.library));
}

TEST(LibraryNotes, stayWhenClipsAreAddedButForThoseOnTheWhole) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].warnings = {{"one row more than declared", {"left.bvh", 9}, WarningTopic::kRows}};
  MotionLibrary base = builtFrom(std::move(documents)).library;
  base.notes.push_back({"an old remark on the whole", {}, WarningTopic::kGraph});
  BvhDocument more =
      documentOf(walkOf({.frames = 90, .speedMetresPerSecond = 1.0, .cyclesPerSecond = 0.85}), "more");
  more.warnings = {{"no unit was given", {"more.bvh"}, WarningTopic::kUnit}};
  auto builder = LibraryBuilder::append(*readSgraph(writeSgraph(base)), {more});
  ASSERT_TRUE(builder);
  while (builder->step()) {
  }
  const Result<MotionLibrary> library = builder->finish();
  ASSERT_TRUE(library);
  const std::vector<std::string> notes = textsOf(library->notes);
  ASSERT_GE(notes.size(), 2U);
  EXPECT_EQ(notes[0], "left.bvh:9: one row more than declared [rows]");
  EXPECT_EQ(notes[1], "more.bvh: no unit was given [unit]");
  for (const std::string& note : notes) EXPECT_EQ(note.find("old remark"), std::string::npos) << note;
}

TEST(LibraryTexts, areUtf8InAFileWhateverTheyWere) {
  Random random(17);
  for (int k = 0; k < 20; ++k) {
    MotionLibrary library = sample();
    library.license = randomBytes(random);
    library.frames.name = randomBytes(random);
    for (Joint& joint : library.skeleton.joints) joint.name = randomBytes(random);
    for (std::string& name : library.layout.endSiteNames) name = randomBytes(random);
    for (LibraryClip& clip : library.clips) clip.name = randomBytes(random);
    library.notes = {{randomBytes(random), {randomBytes(random)}, WarningTopic::kText}};
    const Result<MotionLibrary> read = readSgraph(writeSgraph(library));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->license, toUtf8(library.license));
    EXPECT_EQ(read->frames.name, toUtf8(library.frames.name));
    for (std::size_t j = 0; j < library.skeleton.size(); ++j) {
      EXPECT_EQ(read->skeleton.joints[j].name, toUtf8(library.skeleton.joints[j].name));
      EXPECT_TRUE(isUtf8(read->layout.endSiteNames[j]));
    }
    for (std::size_t c = 0; c < library.clips.size(); ++c)
      EXPECT_EQ(read->clips[c].name, toUtf8(library.clips[c].name));
    ASSERT_EQ(read->notes.size(), 1U);
    EXPECT_EQ(read->notes[0].message, toUtf8(library.notes[0].message));
    EXPECT_EQ(read->notes[0].place.file, toUtf8(library.notes[0].place.file));
  }
}

TEST(LibraryTexts, becomeUtf8WhenALibraryIsBuilt) {
  std::vector<BvhDocument> documents = threeWalks();
  for (BvhDocument& document : documents) {
    document.skeleton.joints[9].name = "poitrine \xe9troite";
    document.clip.name += "\xe4";
    document.warnings = {{"\xfc", {"\xf6.bvh"}, WarningTopic::kText}};
  }
  const Result<BuiltLibrary> built = buildLibrary(std::move(documents), {}, "gemacht f\xfcr alle");
  ASSERT_TRUE(built);
  EXPECT_EQ(built->library.skeleton.joints[9].name, "poitrine étroite");
  EXPECT_EQ(built->library.clips[0].name, "aheadä");
  EXPECT_EQ(built->library.license, "gemacht für alle");
  EXPECT_EQ(describe(built->report.warnings[0]), "ö.bvh: ü");
  EXPECT_EQ(writeSgraph(*readSgraph(writeSgraph(built->library))), writeSgraph(built->library));
}

TEST(LibraryTexts, haveALicenceOfBoundedLength) {
  EXPECT_TRUE(buildLibrary(threeWalks(), {}, std::string(kMostLicenseBytes, 'x')));
  const Result<BuiltLibrary> refused =
      buildLibrary(threeWalks(), {}, std::string(kMostLicenseBytes + 1, 'x'));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "a licence line of 10001 bytes, at most 10000 expected");
}

}  // namespace
}  // namespace stridegraph
