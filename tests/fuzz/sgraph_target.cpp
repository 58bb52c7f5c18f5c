#include <flatbuffers/flatbuffers.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "base/utf8.h"
#include "graph/library_checks.h"
#include "graph/sgraph_file.h"
#include "graph/sgraph_hash.h"
#include "graph/test_library.h"
#include "input.h"
#include "plan_checks.h"
#include "sgraph_generated.h"
#include "text_checks.h"
#include "walk/test_library.h"
#include "walk/walk_planner.h"

namespace stridegraph::fuzz {
namespace {

using File = std::vector<std::uint8_t>;

/// Puts the hash right that the file keeps of itself, where there is one, so that what lies behind is tried.
void sign(File& file) {
  flatbuffers::Verifier verifier(file.data(), file.size(), 64, 1'000'000);
  if (file.size() < 64 || !sgraph::LibraryBufferHasIdentifier(file.data()) ||
      !sgraph::VerifyLibraryBuffer(verifier))
    return;
  const auto* table = flatbuffers::GetRoot<flatbuffers::Table>(file.data());
  const std::uint8_t* place = table->GetAddressOf(sgraph::Library::VT_HASH);
  if (place == nullptr) return;
  const auto at = static_cast<std::size_t>(place - file.data());
  const std::uint64_t hash = hashAround(file, at);
  std::memcpy(file.data() + at, &hash, sizeof(hash));
}

Scene smallRoom() {
  Scene scene;
  scene.widthMetres = 8.0;
  scene.depthMetres = 6.0;
  scene.obstacles = {{{4, 2}, {1, 3}}};
  scene.start = {{1, 2}, Angle::degrees(90)};
  scene.goal = {{7, 2}, {}};
  return scene;
}

/// Walks with a library; it may be of no use, but not do harm.
void walkWith(MotionLibrary library) {
  const WalkPlanner planner(std::make_shared<const MotionLibrary>(std::move(library)));
  PlanOptions options;
  options.clock = countingClock();
  options.budgetMilliseconds = 4.0;
  const Scene scene = smallRoom();
  const Result<Plan> plan = planner.plan(scene, options);
  require(plan.has_value(), "a library that opens can be asked for a walk");
  requireSound(*plan, scene, 2e-3);  // The library's rotations are of unit length within 1e-3.
}

/// Whatever reports and exports hold of a library is UTF-8.
void requireUtf8(const MotionLibrary& library) {
  require(isUtf8(library.license) && isUtf8(library.frames.name), "the texts of a library are UTF-8");
  for (const Joint& joint : library.skeleton.joints) require(isUtf8(joint.name), "names of joints are UTF-8");
  for (const LibraryClip& clip : library.clips) require(isUtf8(clip.name), "names of clips are UTF-8");
  for (const std::string& name : library.layout.endSiteNames)
    require(isUtf8(name), "names of end sites are UTF-8");
}

/// What opens is sound, and the same from its own writing.
void open(Bytes bytes) {
  Result<MotionLibrary> library = readSgraph(bytes);
  if (!library) return requireSound(library.error(), 0);
  require(!faultIn(*library), "a library that opens is sound");
  requireUtf8(*library);
  const Result<MotionLibrary> again = readSgraph(writeSgraph(*library));
  require(again.has_value(), "a library that is written opens");
  require(writeSgraph(*again) == writeSgraph(*library), "a library stays the same from writing to writing");
  walkWith(std::move(*library));
}

template <typename T>
void put(File& file, std::size_t place, T value) {
  if (file.size() < sizeof(T)) return;
  std::memcpy(file.data() + place % (file.size() - sizeof(T) + 1), &value, sizeof(T));
}

constexpr std::array<std::uint32_t, 8> kOddWords = {0,           1,           0x7fffffffU, 0x80000000U,
                                                    0xffffffffU, 0xfffffffeU, 0xffffU,     1000};

/// Alters a sound file as the bytes say: each time a place, and what to put there.
File altered(File file, Input& input) {
  while (input.bytesLeft() > 0) {
    const std::size_t place = input.word() + 65536U * input.below(4);
    const std::size_t what = input.below(5);
    const std::uint8_t value = input.byte();
    if (what == 0) put(file, place, value);
    if (what == 1) put(file, place & ~std::size_t{3}, kOddWords[value % kOddWords.size()]);
    if (what == 2) put(file, place & ~std::size_t{3}, static_cast<float>(Input::kOddNumbers[value % 16]));
    if (what == 3) put(file, place & ~std::size_t{3}, Input::kOddNumbers[value % 16]);
    if (what == 4) put(file, place & ~std::size_t{3}, static_cast<std::uint32_t>(value));
  }
  return file;
}

const File& sample(std::size_t which) {
  static const std::array<File, 3> samples = {writeSgraph(testing::threeArcs()),
                                              writeSgraph(testing::threeArcsAndAStop()),
                                              writeSgraph(testing::builtFrom(testing::threeWalks()).library)};
  return samples[which];
}

}  // namespace

void trySgraph(Bytes bytes) {
  File file(bytes.begin(), bytes.end());
  sign(file);
  open(file);
  Input input(bytes);
  file = altered(sample(input.below(3)), input);
  sign(file);
  open(file);
}

}  // namespace stridegraph::fuzz
