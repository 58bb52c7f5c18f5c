#include "library_file.h"

#include "graph/sgraph_file.h"
#include "program/files.h"
#include "program/shown_text.h"

namespace stridegraph::tools {

Result<MotionLibrary> readLibraryFile(const std::string& path) {
  auto bytes = readFile(path, kMostLibraryBytes);
  if (!bytes) return fail(std::move(bytes));
  auto library = readSgraph(bytesOf(*bytes));
  if (!library) library.error().place.file = shownText(path);
  return library;
}

}  // namespace stridegraph::tools
