#include "graph/library_limits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <sstream>

#include "graph/library_checks.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

/// The section of a document below a heading of the second level.
std::string sectionOf(const std::string& document, const std::string& heading) {
  const std::size_t begin = document.find("\n## " + heading + "\n");
  if (begin == std::string::npos) return {};
  const std::size_t end = document.find("\n## ", begin + 1);
  return document.substr(begin, end == std::string::npos ? end : end - begin);
}

/// With a blank after each three digits, as documents write numbers.
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ' ');
  return digits;
}

TEST(LibraryLimits, areDocumentedWithTheirNumbers) {
  const std::string section = sectionOf(
      testing::contentOf(std::filesystem::path(STRIDEGRAPH_DOCS) / "motion-files.md"), "Limits of a library");
  ASSERT_FALSE(section.empty());
  const std::pair<const char*, std::size_t> rows[] = {{"Clips", kMostLibraryClips},
                                                      {"Frames", kMostLibraryFrames},
                                                      {"Rotations", kMostLibraryRotations},
                                                      {"Regions", kMostLibraryRegions},
                                                      {"Notes", kMostLibraryNotes},
                                                      {"Bytes of a note", kMostNoteBytes},
                                                      {"Bytes of the licence line", kMostLicenseBytes}};
  for (const auto& [name, number] : rows)
    EXPECT_NE(section.find(fmt::format("| {} | {} |", name, grouped(number))), std::string::npos)
        << name << " " << grouped(number);
}

TEST(LibraryLimits, ofParametersAreDocumentedAsTheyAreRefused) {
  const std::string section = sectionOf(
      testing::contentOf(std::filesystem::path(STRIDEGRAPH_DOCS) / "motion-files.md"), "Limits of a library");
  EXPECT_NE(section.find("| Frames of a transition | 2 to 120 |"), std::string::npos);
  EXPECT_FALSE(faultIn(LibraryParams{.transitionFrames = 2}));
  EXPECT_FALSE(faultIn(LibraryParams{.transitionFrames = 120}));
  EXPECT_TRUE(faultIn(LibraryParams{.transitionFrames = 121}));
  EXPECT_NE(section.find("| Frames a second | 1 to 240 |"), std::string::npos);
  EXPECT_FALSE(faultIn(LibraryParams{.framesPerSecond = 240.0}));
  EXPECT_TRUE(faultIn(LibraryParams{.framesPerSecond = 240.5}));
  EXPECT_NE(section.find("| Transitions kept | 15 000, or as asked: 1 000 or more |"), std::string::npos);
  EXPECT_EQ(LibraryParams{}.mostTransitions, 15'000U);
  EXPECT_TRUE(faultIn(LibraryParams{.mostTransitions = 999}));
}

}  // namespace
}  // namespace stridegraph
