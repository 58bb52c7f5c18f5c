#include "build_report.h"

#include "base/hash.h"
#include "program/json_document.h"

namespace stridegraph::tools {

std::string buildReportText(const BuildReport& report, const BuildOutcome& outcome) {
  Json json;
  json["status"] = outcome.error == nullptr ? "built" : std::string(errorCodeName(outcome.error->code));
  json["explanation"] = outcome.error == nullptr ? std::string() : describe(*outcome.error);
  json["frame_pairs"] = report.framePairs;
  json["before_pruning"] = {{"nodes", report.nodesBeforePruning},
                            {"clip_pieces", report.clipPiecesBeforePruning},
                            {"transitions", report.transitionsBeforePruning}};
  json["after_pruning"] = {
      {"nodes", report.nodes}, {"clip_pieces", report.clipPieces}, {"transitions", report.transitions}};
  json["transitions_before_thinning"] = report.transitionsBeforeThinning;
  json["surviving_share"] = report.survivingShare;
  for (const ClipFate& clip : report.clips) {
    json["clips"].push_back({{"name", clip.name},
                             {"frames", clip.frames},
                             {"transitions", clip.transitions},
                             {"surviving_frames", clip.survivingFrames},
                             {"reason", clip.reason}});
  }
  Warnings notes = outcome.notes;
  notes.insert(notes.end(), report.warnings.begin(), report.warnings.end());
  json["warnings"] = Json::array();
  for (const Warning& note : notes) json["warnings"].push_back(describe(note));
  json["notes"] = notesJson(notes);
  if (outcome.library != nullptr) json["library_hash"] = hexDigits(outcome.library->hash);
  return documentText(json);
}

}  // namespace stridegraph::tools
