#include "motion/export_names.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "base/utf8.h"

namespace stridegraph {
namespace {

/// U+0000 to U+001F and U+007F are single bytes; U+0080 to U+009F are C2 80 to C2 9F.
bool isSingleControl(char c) {
  return static_cast<unsigned char>(c) < 0x20U || c == '\x7F';
}

bool isDoubleControl(std::string_view text, std::size_t at) {
  return text[at] == '\xC2' && at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) < 0xA0U;
}

}  // namespace

std::string exportName(std::string_view name, std::string_view fallback) {
  const std::string text = toUtf8(name);
  const std::size_t first = text.find_first_not_of(" \t\r\n\v\f");
  if (first == std::string::npos) return std::string(fallback);
  const std::size_t end = text.find_last_not_of(" \t\r\n\v\f") + 1;
  std::string cleaned;
  for (std::size_t i = first; i < end; ++i) {
    const bool isDouble = isDoubleControl(text, i);
    cleaned.push_back(isDouble || isSingleControl(text[i]) ? '_' : text[i]);
    if (isDouble) ++i;
  }
  return cleaned;
}

std::vector<std::string> madeUnique(std::vector<std::string> names) {
  std::set<std::string> taken(names.begin(), names.end());
  std::set<std::string> seen;
  std::map<std::string, std::size_t> counts;
  for (std::string& name : names) {
    if (seen.insert(name).second) continue;
    std::size_t& count = counts.try_emplace(name, 1).first->second;
    std::string wanted;
    do {
      wanted = fmt::format("{}_{}", name, ++count);
    } while (!taken.insert(wanted).second);
    name = std::move(wanted);
    seen.insert(name);
  }
  return names;
}

}  // namespace stridegraph
