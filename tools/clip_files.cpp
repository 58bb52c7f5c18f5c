#include "clip_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "motion/bvh_limits.h"
#include "program/file_identity.h"
#include "program/files.h"
#include "program/shown_text.h"

namespace stridegraph::tools {

std::vector<std::string> withoutRepeats(const std::vector<std::string>& paths, Warnings& notes) {
  std::vector<std::string> kept;
  std::vector<FileIdentity> identities;
  for (const std::string& path : paths) {
    const FileIdentity identity(path);
    const auto known = std::find_if(identities.begin(), identities.end(),
                                    [&](const FileIdentity& other) { return other.isSameAs(identity); });
    if (known == identities.end()) {
      kept.push_back(path);
      identities.push_back(identity);
      continue;
    }
    const std::string& first = kept[static_cast<std::size_t>(known - identities.begin())];
    notes.push_back({fmt::format("is the same file as {}, which is taken once", shownText(first)),
                     {shownText(path)},
                     WarningTopic::kGraph});
  }
  return kept;
}

Result<std::vector<BvhDocument>> readClipFiles(const std::vector<std::string>& paths,
                                               const BvhReadParams& params,
                                               const std::function<void(double)>& progress) {
  std::vector<BvhDocument> clips;
  for (const std::string& path : paths) {
    progress(static_cast<double>(clips.size()) / static_cast<double>(paths.size()));
    auto bytes = readFile(path, kMostBvhBytes);
    if (!bytes) return fail(std::move(bytes));
    auto clip = readBvh(*bytes, shownText(path), params);
    if (!clip) return fail(std::move(clip));
    clip->clip.name = shownText(std::filesystem::path(path).stem().string());
    clips.push_back(std::move(*clip));
  }
  return clips;
}

}  // namespace stridegraph::tools
