#include "program/json_document.h"

namespace stridegraph::tools {

Json notesJson(const Warnings& notes) {
  Json list = Json::array();
  for (const Warning& note : notes) {
    Json entry = {{"topic", warningTopicName(note.topic)}, {"message", note.message}};
    if (!note.place.file.empty()) entry["file"] = note.place.file;
    if (note.place.line > 0) entry["line"] = note.place.line;
    if (note.place.column > 0) entry["column"] = note.place.column;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace stridegraph::tools
