#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "math/rotation.h"
#include "motion/bvh_reader.h"
#include "motion/bvh_writer.h"

namespace stridegraph {
namespace {

/// Reads any text; what can be read must come back from writing as the same motion.
void readWriteRead(std::string_view text, const BvhReadParams& params) {
  const Result<BvhDocument> document = readBvh(text, "fuzz.bvh", params);
  if (!document) {
    STRIDEGRAPH_CHECK(!document.error().message.empty());
    return;
  }
  const std::string written = writeBvh(document->skeleton, document->layout, document->clip);
  const Result<BvhDocument> back =
      readBvh(written, "written.bvh", {document->layout.unitsPerMetre, document->layout.up});
  STRIDEGRAPH_CHECK(back.has_value());
  STRIDEGRAPH_CHECK(back->clip.frameCount() == document->clip.frameCount());
  STRIDEGRAPH_CHECK(differenceBetween(document->skeleton, back->skeleton, 1e-4).empty());
  for (std::size_t f = 0; f < back->clip.frameCount(); ++f) {
    STRIDEGRAPH_CHECK((back->clip.rootPositions[f] - document->clip.rootPositions[f]).norm() < 1e-4);
  }
  for (std::size_t i = 0; i < back->clip.rotations.size(); ++i) {
    STRIDEGRAPH_CHECK(angleBetween(back->clip.rotations[i], document->clip.rotations[i]).degrees() < 0.01);
  }
}

}  // namespace
}  // namespace stridegraph

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  stridegraph::readWriteRead(text, {});
  stridegraph::readWriteRead(text, {100.0, stridegraph::UpAxis::kZ});
  return 0;
}
