#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/utf8.h"
#include "graph/library_checks.h"
#include "math/rotation.h"
#include "motion/bvh_reader.h"
#include "motion/bvh_writer.h"
#include "motion/glb_writer.h"
#include "target.h"
#include "text_checks.h"

namespace stridegraph::fuzz {
namespace {

/// A last byte from 0x80 on says how the numbers are to be understood; others belong to the text.
bool saysParams(Bytes bytes) {
  return !bytes.empty() && bytes.back() >= 0x80U;
}

BvhReadParams paramsFrom(Bytes bytes) {
  constexpr double kUnits[] = {1.0, 100.0, 39.37, 1e-6, 1e9, 0.0, -1.0, 1e300};
  BvhReadParams params;
  if (!saysParams(bytes)) return params;
  const unsigned last = bytes.back();
  if ((last & 1U) != 0) params.up = (last & 2U) != 0 ? UpAxis::kZ : UpAxis::kY;
  if ((last & 4U) != 0) params.unitsPerMetre = kUnits[(last >> 3U) % 8];
  return params;
}

void requireSound(const BvhDocument& document, std::size_t lines) {
  fuzz::requireSound(document.warnings, lines);
  require(!faultIn(document.skeleton), "what is read has a sound skeleton");
  require(!faultIn(document.skeleton, document.clip), "what is read is a sound clip");
  require(document.clip.frameCount() > 0, "what is read has frames");
  for (const Joint& joint : document.skeleton.joints)
    require(isUtf8(joint.name), "names of joints are UTF-8");
  for (const std::string& name : document.layout.endSiteNames)
    require(isUtf8(name), "names of end sites are UTF-8");
  for (const double confidence : {document.confidence.unit, document.confidence.up})
    require(confidence >= 0.0 && confidence <= 1.0, "confidence is a share");
}

/// The motion comes back from its own text.
void requireWritable(const BvhDocument& document) {
  const std::string written = writeBvh(document.skeleton, document.layout, document.clip);
  require(isUtf8(written), "a written BVH is UTF-8");
  const Result<BvhDocument> back =
      readBvh(written, "written.bvh", {document.layout.unitsPerMetre, document.layout.up});
  if (!back) throw BrokenPromise("what is written can be read: " + describe(back.error()));
  require(back->clip.frameCount() == document.clip.frameCount(), "writing keeps the number of frames");
  const std::string difference = differenceBetween(document.skeleton, back->skeleton, 1e-4);
  require(difference.empty(), "writing keeps the skeleton: " + difference);
  for (std::size_t f = 0; f < back->clip.frameCount(); ++f) {
    require((back->clip.rootPositions[f] - document.clip.rootPositions[f]).norm() < 1e-4,
            "writing keeps the root within 0.1 mm");
  }
  for (std::size_t i = 0; i < back->clip.rotations.size(); ++i) {
    require(angleBetween(back->clip.rotations[i], document.clip.rotations[i]).degrees() < 0.01,
            "writing keeps rotations within 0.01 degrees");
  }
}

/// The JSON of a binary glTF can be read by any reader.
void requireGlb(const BvhDocument& document) {
  const RoundBody body = roundBody(document.skeleton, document.clip);
  const std::vector<std::uint8_t> glb = writeGlb(document.skeleton, body, document.clip);
  constexpr std::size_t kHeader = 20;
  require(glb.size() > kHeader, "a GLB has a header");
  const std::size_t size = glb[12] + 256U * glb[13] + 65536U * glb[14] + 16777216U * glb[15];
  require(kHeader + size <= glb.size(), "the JSON of a GLB fits into it");
  const auto* text = reinterpret_cast<const char*>(glb.data()) + kHeader;
  require(nlohmann::json::accept(text, text + size), "the JSON of a GLB is JSON, and UTF-8");
}

}  // namespace

void tryBvh(Bytes bytes) {
  const std::size_t size = bytes.size() - (saysParams(bytes) ? 1 : 0);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), size);
  const Result<BvhDocument> document = readBvh(text, "fuzz.bvh", paramsFrom(bytes));
  const std::size_t lines = mostLines(text);
  if (!document) return fuzz::requireSound(document.error(), lines);
  requireSound(*document, lines);
  requireWritable(*document);
  requireGlb(*document);
}

}  // namespace stridegraph::fuzz
