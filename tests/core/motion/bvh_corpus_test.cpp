#include <gtest/gtest.h>

#include <filesystem>

#include "motion/bvh_texts.h"
#include "motion/bvh_writer.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

/// The fuzzer begins with these texts and leaves here what once broke the reader. Their names say what is to
/// become of them: read_... or refused_...
TEST(BvhCorpus, isReadOrRefusedAsTheNamesSay) {
  std::size_t read = 0;
  std::size_t refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STRIDEGRAPH_TEST_DATA "/bvh")) {
    const std::string name = entry.path().filename().string();
    const Result<BvhDocument> document = readBvh(testing::contentOf(entry.path()), name);
    EXPECT_EQ(document.has_value(), name.starts_with("read_")) << name;
    if (!document) {
      ++refused;
      EXPECT_TRUE(name.starts_with("refused_")) << describe(document.error());
      EXPECT_GT(document.error().place.line, 0U) << name;
      continue;
    }
    ++read;
    const BvhDocument back = testing::read(writeBvh(document->skeleton, document->layout, document->clip),
                                           {document->layout.unitsPerMetre, document->layout.up});
    EXPECT_LT(testing::greatestDistance(*document, back), 1e-4) << name;
    EXPECT_LT(testing::greatestAngleDegrees(document->clip, back.clip), 0.01) << name;
  }
  EXPECT_GE(read, 7U);
  EXPECT_GE(refused, 8U);
}

}  // namespace
}  // namespace stridegraph
