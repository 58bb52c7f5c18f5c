#include "builder_handle.h"

#include <memory>

#include "clip_reader.h"
#include "graph/sgraph_file.h"
#include "js_values.h"
#include "library_handle.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

val fateValue(const ClipFate& fate) {
  val value = val::object();
  value.set("name", textValue(fate.name));
  value.set("frames", static_cast<double>(fate.frames));
  value.set("transitions", static_cast<double>(fate.transitions));
  value.set("survivingFrames", static_cast<double>(fate.survivingFrames));
  value.set("reason", textValue(fate.reason));
  return value;
}

val reportValue(const BuildReport& report) {
  val clips = val::array();
  for (const ClipFate& fate : report.clips) clips.call<void>("push", fateValue(fate));
  val value = val::object();
  value.set("framePairs", static_cast<double>(report.framePairs));
  value.set("nodesBeforePruning", static_cast<double>(report.nodesBeforePruning));
  value.set("clipPiecesBeforePruning", static_cast<double>(report.clipPiecesBeforePruning));
  value.set("transitionsBeforePruning", static_cast<double>(report.transitionsBeforePruning));
  value.set("nodes", static_cast<double>(report.nodes));
  value.set("clipPieces", static_cast<double>(report.clipPieces));
  value.set("transitions", static_cast<double>(report.transitions));
  value.set("transitionsBeforeThinning", static_cast<double>(report.transitionsBeforeThinning));
  value.set("survivingShare", report.survivingShare);
  value.set("clips", clips);
  value.set("warnings", warningList(report.warnings));
  return value;
}

}  // namespace

val BuilderHandle::create(const val& options, const val& base) {
  Result<BuildOptions> read = readBuildOptions(options);
  if (!read) return refuse(read.error());
  std::optional<MotionLibrary> library;
  if (!base.isUndefined()) {
    Result<MotionLibrary> opened = readSgraph(emscripten::convertJSArrayToNumberVector<std::uint8_t>(base));
    if (!opened) return refuse(opened.error());
    library = *std::move(opened);
  }
  return succeed(val(std::make_shared<BuilderHandle>(*std::move(read), std::move(library))));
}

val BuilderHandle::addClip(const val& clip) {
  Result<BvhDocument> document = readBvhClip(clip, options_.reading);
  if (!document) return refuse(document.error());
  documents_.push_back(*std::move(document));
  return succeed(val::undefined());
}

val BuilderHandle::start() {
  Result<LibraryBuilder> builder =
      base_ ? LibraryBuilder::append(*std::move(base_), std::move(documents_), options_.license)
            : LibraryBuilder::start(std::move(documents_), options_.library, options_.license);
  base_.reset();
  documents_.clear();
  if (!builder) return refuse(builder.error());
  builder_.emplace(*std::move(builder));
  return succeed(val::undefined());
}

bool BuilderHandle::step() {
  return builder_ && builder_->step();
}

double BuilderHandle::progress() const {
  return builder_ ? builder_->progress() : 0.0;
}

double BuilderHandle::framePairs() const {
  return builder_ ? static_cast<double>(builder_->report().framePairs) : 0.0;
}

val BuilderHandle::finish() {
  Result<MotionLibrary> library = builder_->finish();
  if (!library) return refuse(library.error());
  val value = val::object();
  value.set("report", reportValue(builder_->report()));
  value.set("library", val(std::make_shared<LibraryHandle>(*std::move(library))));
  return succeed(value);
}

}  // namespace stridegraph::bindings
