// How many pairs of frames are compared in a second on one core: the distances alone, with the search for
// transitions, and by the plain loop; and what share that is of a matrix product's speed in the same run.
//   build/release/bench/similarity_bench [--json | --clips FOLDER]
// --clips writes the clips that are compared, as BVH, for similarity_node.mjs.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

#include "base/check.h"
#include "bench/varied_clips.h"
#include "fastest.h"
#include "graph/pose_distance.h"
#include "graph/transition_scan.h"
#include "matrix_product.h"
#include "motion/bvh_writer.h"

namespace stridegraph::bench {
namespace {

constexpr std::size_t kJoints = 20;
constexpr std::size_t kFrames = 1'500;
constexpr std::size_t kFramesOfPlainLoop = 100;
constexpr int kTurns = 60;

/// The products and their sums that one pair of frames costs: along, across and height of each joint, along
/// and across of the path of the centre. What combines them comes on top.
constexpr std::size_t kOperationsOfPair = 2 * (5 * kJoints + 4 * ClipFeatures::kMotionPoints);

/// The default character with as many joints that count: some of its tips become joints like others.
std::vector<BvhDocument> clipsOfManyJoints(std::size_t frames) {
  std::vector<BvhDocument> documents = variedGaitClips(frames, 1);
  Skeleton skeleton = documents.front().skeleton;
  const auto counting = [&] {
    const std::vector<double> weights = distanceWeights(skeleton);
    return static_cast<std::size_t>(std::accumulate(weights.begin(), weights.end(), 0.0));
  };
  for (std::size_t j = 0; j < skeleton.size() && counting() < kJoints; ++j) {
    if (distanceWeights(skeleton)[j] == 0.0)
      skeleton.joints[j] = {fmt::format("extra {}", j), skeleton.joints[j].parent, skeleton.joints[j].offset};
  }
  for (BvhDocument& document : documents) document.skeleton = skeleton;
  return documents;
}

std::vector<Clip> clipsOf(const std::vector<BvhDocument>& documents) {
  std::vector<Clip> clips;
  for (const BvhDocument& document : documents) clips.push_back(document.clip);
  return clips;
}

struct Prepared {
  Skeleton skeleton;
  std::vector<Clip> clips;
  std::vector<ClipFeatures> features;
};

Prepared prepare() {
  const std::vector<BvhDocument> documents = clipsOfManyJoints(kFrames);
  Prepared prepared{documents.front().skeleton, clipsOf(documents), {}};
  const FeatureBasis basis = featureBasis(prepared.skeleton, prepared.clips);
  for (const Clip& clip : prepared.clips) prepared.features.emplace_back(prepared.skeleton, basis, clip);
  return prepared;
}

/// Compares all pairs of clips; their pairs of frames.
std::size_t compareAll(const Prepared& prepared, DistanceRows& rows) {
  std::size_t pairs = 0;
  for (const ClipFeatures& a : prepared.features) {
    for (const ClipFeatures& b : prepared.features) {
      rows.restart(a, b);
      while (rows.advance() != 0) {
      }
      pairs += a.windowCount() * b.windowCount();
    }
  }
  return pairs;
}

std::size_t scanAll(const Prepared& prepared) {
  TransitionScan scan(prepared.features, ValleyParams{});
  while (scan.step()) {
  }
  return scan.framePairs();
}

/// The plain loop over all pairs of windows, whose positions are known.
class PlainLoop {
 public:
  explicit PlainLoop(const Prepared& prepared) : weights_(windowWeights(prepared.skeleton)) {
    for (const Clip& clip : prepared.clips) {
      for (std::size_t f = kWindowReach; f + kWindowReach < clip.frameCount(); ++f) {
        if (windows_.size() < kFramesOfPlainLoop)
          windows_.push_back(windowPositions(prepared.skeleton, clip, f));
      }
    }
  }
  std::size_t compareAll() {
    for (const std::vector<Vec3>& a : windows_) {
      for (const std::vector<Vec3>& b : windows_) sum_ += windowDistanceMetres(a, b, weights_);
    }
    return windows_.size() * windows_.size();
  }
  double sum() const { return sum_; }

 private:
  std::vector<double> weights_;
  std::vector<std::vector<Vec3>> windows_;
  double sum_ = 0.0;
};

/// Takes turns between all that is measured, so that none has the machine at a better time than another.
nlohmann::ordered_json measure() {
  const Prepared prepared = prepare();
  DistanceRows distances(prepared.features[0], prepared.features[0]);
  PlainLoop loop(prepared);
  std::optional<MatrixProduct> product = MatrixProduct::create();
  Fastest rows;
  Fastest scan;
  Fastest plain;
  Fastest matrix;
  for (int turn = 0; turn < kTurns; ++turn) {
    rows.time([&] { return compareAll(prepared, distances); });
    scan.time([&] { return scanAll(prepared); });
    plain.time([&] { return loop.compareAll(); });
    if (product) matrix.time([&] { return product->multiply(); });
  }
  STRIDEGRAPH_CHECK(loop.sum() > 0.0);
  nlohmann::ordered_json table = {
      {"joints", prepared.features.front().jointCount()},
      {"window", kWindowFrames},
      {"frames", kFrames},
      {"pairsPerSecond",
       {{"rows", rows.perSecond()}, {"rowsAndScan", scan.perSecond()}, {"plainLoop", plain.perSecond()}}}};
  const double gigaflops = rows.perSecond() * static_cast<double>(kOperationsOfPair) / 1e9;
  table["gigaflops"]["rows"] = gigaflops;
  if (!product) return table;
  table["gigaflops"]["matrixProduct"] = matrix.perSecond() / 1e9;
  table["shareOfMatrixProduct"] = gigaflops / (matrix.perSecond() / 1e9);
  return table;
}

void print(const nlohmann::ordered_json& table) {
  const auto millions = [&](const char* what) { return table["pairsPerSecond"][what].get<double>() / 1e6; };
  fmt::print("{} joints, window of {} frames, one core; million pairs of frames a second\n",
             table["joints"].get<int>(), table["window"].get<int>());
  fmt::print("{:8.1f}  distances\n{:8.1f}  distances and search for transitions\n{:8.3f}  plain loop\n",
             millions("rows"), millions("rowsAndScan"), millions("plainLoop"));
  if (table.contains("shareOfMatrixProduct"))
    fmt::print("{:8.1f}  GFLOP/s of {:.1f} of a matrix product: {:.0f} %\n",
               table["gigaflops"]["rows"].get<double>(), table["gigaflops"]["matrixProduct"].get<double>(),
               100.0 * table["shareOfMatrixProduct"].get<double>());
}

nlohmann::ordered_json describe(const std::vector<BvhDocument>& documents) {
  return {{"joints", kJoints}, {"window", kWindowFrames}, {"clips", documents.size()}};
}

/// Writes the clips into a folder that exists, as 0.bvh, 1.bvh and so on.
bool writeClips(const std::string& folder) {
  const std::vector<BvhDocument> documents = clipsOfManyJoints(kFrames);
  for (std::size_t c = 0; c < documents.size(); ++c) {
    std::ofstream file(fmt::format("{}/{}.bvh", folder, c));
    file << writeBvh(documents[c].skeleton, documents[c].layout, documents[c].clip);
    if (!file) return false;
  }
  fmt::print("{}\n", describe(documents).dump());
  return true;
}

}  // namespace
}  // namespace stridegraph::bench

int main(int argumentCount, char** arguments) {
  using namespace stridegraph;
  const std::string_view option = argumentCount > 1 ? arguments[1] : "";
  if (option == "--clips")
    return argumentCount == 3 && bench::writeClips(arguments[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
  const nlohmann::ordered_json table = bench::measure();
  if (option == "--json")
    fmt::print("{}\n", table.dump(2));
  else
    bench::print(table);
  return EXIT_SUCCESS;
}
