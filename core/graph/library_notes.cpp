#include "graph/library_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "base/utf8.h"
#include "graph/library_limits.h"

namespace stridegraph {
namespace {

constexpr std::string_view kCutMark = "...";

/// Whether a byte goes on with a character of UTF-8.
bool isContinuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

/// As UTF-8, cut between two characters where it is too long for a note.
std::string noteText(const std::string& bytes) {
  std::string text = toUtf8(bytes);
  if (text.size() <= kMostNoteBytes) return text;
  std::size_t end = kMostNoteBytes - kCutMark.size();
  while (end > 0 && isContinuation(text[end])) --end;
  text.resize(end);
  return text.append(kCutMark);
}

}  // namespace

void makeTextsUtf8(BvhDocument& document) {
  document.clip.name = toUtf8(document.clip.name);
  for (Joint& joint : document.skeleton.joints) joint.name = toUtf8(joint.name);
  for (std::string& name : document.layout.endSiteNames) name = toUtf8(name);
  for (BvhStillJoint& still : document.layout.still.joints) {
    still.joint.name = toUtf8(still.joint.name);
    still.endSiteName = toUtf8(still.endSiteName);
  }
  for (Warning& warning : document.warnings) {
    warning.message = toUtf8(warning.message);
    warning.place.file = toUtf8(warning.place.file);
  }
}

Warnings keepableNotes(const Warnings& notes) {
  Warnings kept;
  std::set<std::tuple<std::string, std::string, std::size_t, std::size_t, WarningTopic>> seen;
  for (const Warning& note : notes) {
    Warning one{
        noteText(note.message), {noteText(note.place.file), note.place.line, note.place.column}, note.topic};
    if (seen.emplace(one.message, one.place.file, one.place.line, one.place.column, one.topic).second)
      kept.push_back(std::move(one));
  }
  if (kept.size() <= kMostLibraryNotes) return kept;
  const std::size_t left = kept.size() - (kMostLibraryNotes - 1);
  kept.resize(kMostLibraryNotes - 1);
  kept.push_back(
      {fmt::format("{} further notes are not kept: a library holds {} at most", left, kMostLibraryNotes),
       {},
       WarningTopic::kOther});
  return kept;
}

Warnings notesThatStay(const Warnings& notes) {
  Warnings staying = notes;
  std::erase_if(staying, [](const Warning& note) { return note.topic == WarningTopic::kGraph; });
  return staying;
}

}  // namespace stridegraph
