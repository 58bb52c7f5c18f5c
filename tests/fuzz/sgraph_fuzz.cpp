#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "base/check.h"
#include "graph/library_checks.h"
#include "graph/sgraph_file.h"
#include "graph/sgraph_hash.h"
#include "graph/test_library.h"

namespace stridegraph {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A sound file, and where in it its hash lies.
struct Sample {
  Bytes bytes;
  std::size_t hashPlace = 0;
};

Sample makeSample() {
  const MotionLibrary library = testing::builtFrom(testing::threeWalks()).library;
  Sample sample{writeSgraph(library), 0};
  std::array<std::uint8_t, sizeof(library.hash)> hash;
  std::memcpy(hash.data(), &library.hash, hash.size());
  const auto place = std::search(sample.bytes.begin(), sample.bytes.end(), hash.begin(), hash.end());
  STRIDEGRAPH_CHECK(place != sample.bytes.end());
  sample.hashPlace = static_cast<std::size_t>(place - sample.bytes.begin());
  return sample;
}

/// What loads is sound and loads again from its own writing.
void readAndCheck(std::span<const std::uint8_t> bytes) {
  const Result<MotionLibrary> library = readSgraph(bytes);
  if (!library) return;
  STRIDEGRAPH_CHECK(!faultIn(*library));
  STRIDEGRAPH_CHECK(readSgraph(writeSgraph(*library)).has_value());
}

/// Alters a sound file as the data say, four bytes at a time: three of place, one of value. Its hash is made
/// to hold again, so that what lies behind it is tried, too.
Bytes altered(const Sample& sample, std::span<const std::uint8_t> data) {
  Bytes bytes = sample.bytes;
  for (; data.size() >= 4; data = data.subspan(4)) {
    const std::size_t place = data[0] + 256U * data[1] + 65536U * data[2];
    bytes[place % bytes.size()] = data[3];
  }
  const std::uint64_t hash = hashAround(bytes, sample.hashPlace);
  std::memcpy(bytes.data() + sample.hashPlace, &hash, sizeof(hash));
  return bytes;
}

}  // namespace
}  // namespace stridegraph

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stridegraph;
  static const Sample sample = makeSample();
  readAndCheck({data, size});
  readAndCheck(altered(sample, {data, size}));
  return 0;
}
