#include "clip_reader.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "js_values.h"
#include "motion/body_evidence.h"
#include "options.h"
#include "walk_values.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

/// Names of what is doubtful, as topics of warnings.
val doubtsOf(const BvhConfidence& confidence) {
  val doubts = val::array();
  if (confidence.unit < kDoubtfulConfidence)
    doubts.call<void>("push", std::string(warningTopicName(WarningTopic::kUnit)));
  if (confidence.up < kDoubtfulConfidence)
    doubts.call<void>("push", std::string(warningTopicName(WarningTopic::kUpAxis)));
  return doubts;
}

/// As bodies are measured to tell their unit.
double heightOf(const BvhDocument& document) {
  const BodyExtents extents = measureExtents(document.skeleton, document.clip);
  return std::max(extents.posed.y(), extents.rest.y());
}

val inspectionValue(const BvhDocument& document) {
  const Clip& clip = document.clip;
  const auto frames = static_cast<double>(clip.frameCount());
  val value = val::object();
  value.set("name", textValue(clip.name));
  value.set("joints", jointValues(document.skeleton));
  value.set("frames", frames);
  value.set("fps", clip.framesPerSecond);
  value.set("seconds", frames / clip.framesPerSecond);
  value.set("unitsPerMetre", document.layout.unitsPerMetre);
  value.set("unitConfidence", document.confidence.unit);
  value.set("up", std::string(document.layout.up == UpAxis::kY ? "y" : "z"));
  value.set("upConfidence", document.confidence.up);
  value.set("doubts", doubtsOf(document.confidence));
  value.set("heightMetres", heightOf(document));
  value.set("warnings", warningList(document.warnings));
  return value;
}

}  // namespace

Result<BvhDocument> readBvhClip(const val& clip, const BvhReadParams& otherwise) {
  Result<BvhReadParams> reading = readReadingOptions(clip["reading"], "clip options");
  if (!reading) return fail(std::move(reading));
  if (!reading->unitsPerMetre) reading->unitsPerMetre = otherwise.unitsPerMetre;
  if (!reading->up) reading->up = otherwise.up;
  const auto bytes = emscripten::convertJSArrayToNumberVector<std::uint8_t>(clip["bytes"]);
  const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return readBvh(file, textFrom(clip["name"]), *reading);
}

val inspectClip(const val& clip, const val& options) {
  const Result<BvhReadParams> reading = readReadingOptions(options, "reading options");
  if (!reading) return refuse(reading.error());
  const Result<BvhDocument> document = readBvhClip(clip, *reading);
  if (!document) return refuse(document.error());
  return succeed(inspectionValue(*document));
}

}  // namespace stridegraph::bindings
