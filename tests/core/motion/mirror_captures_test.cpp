#include <gtest/gtest.h>

#include "motion/bvh_texts.h"
#include "motion/captures.h"
#include "motion/kinematics.h"
#include "motion/mirror.h"

namespace stridegraph {
namespace {

struct Library {
  Skeleton skeleton;
  std::vector<Clip> clips;
};

Library libraryOf(std::string_view folder) {
  Library library;
  for (const std::filesystem::path& file : testing::captures(folder)) {
    BvhDocument document = testing::read(testing::contentOf(file));
    library.skeleton = document.skeleton;
    library.clips.push_back(std::move(document.clip));
  }
  return library;
}

struct MirrorFigures {
  double greatestError = 0.0;     ///< Metres between a joint and its partner's reflection.
  double greatestMeanTurn = 0.0;  ///< Degrees between a joint's mean rotation in clips and mirrored clips.
};

Quat meanRotation(const std::vector<Clip>& clips, std::size_t joint) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Clip& clip : clips) {
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const Eigen::Vector4d q = clip.pose(f).rotations[joint].coeffs();
      sum += sum.dot(q) < 0.0 ? Eigen::Vector4d(-q) : q;
    }
  }
  return Quat(sum).normalized();
}

MirrorFigures mirrorFigures(const Library& library) {
  MirrorFigures figures;
  const Result<MirrorMap> map = findMirrorMap(library.skeleton, library.clips);
  EXPECT_TRUE(map);
  if (!map) return figures;
  std::vector<Clip> others;
  for (const Clip& clip : library.clips) {
    const Clip& other = others.emplace_back(mirrored(library.skeleton, *map, clip));
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const std::vector<Vec3> original = jointPositions(library.skeleton, clip.pose(f));
      const std::vector<Vec3> reflection = jointPositions(library.skeleton, other.pose(f));
      for (std::size_t j = 0; j < original.size(); ++j) {
        const Vec3 apart = reflection[j] - mirrored(original[map->partner[j].value]);
        figures.greatestError = std::max(figures.greatestError, apart.norm());
      }
    }
  }
  for (std::size_t j = 1; j < library.skeleton.size(); ++j) {
    const Angle turn = angleBetween(meanRotation(library.clips, j), meanRotation(others, j));
    figures.greatestMeanTurn = std::max(figures.greatestMeanTurn, turn.degrees());
  }
  return figures;
}

TEST(MirroredCaptures, reflectASymmetricBodyExactly) {
  const Library library = libraryOf("cmu16_walk");
  if (library.clips.empty()) GTEST_SKIP() << testing::kNoCaptures;
  EXPECT_LT(mirrorFigures(library).greatestError, 1e-6);
}

TEST(MirroredCaptures, reflectABodyWithArbitraryRestAxesWithinItsOwnAsymmetry) {
  const Library library = libraryOf("accad_male1_walk");
  if (library.clips.empty()) GTEST_SKIP() << testing::kNoCaptures;
  const MirrorFigures figures = mirrorFigures(library);
  EXPECT_LT(figures.greatestError, 0.02);
  // Were a joint's axes twisted wrongly, its mean rotation would jump by more; 25 degrees are how one-sidedly
  // people hold their arms.
  EXPECT_LT(figures.greatestMeanTurn, 35.0);
}

}  // namespace
}  // namespace stridegraph
