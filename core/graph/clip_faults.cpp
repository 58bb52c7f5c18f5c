#include "graph/clip_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "graph/library_checks.h"
#include "graph/library_limits.h"
#include "graph/skeleton_comparison.h"

namespace stridegraph {
namespace {

using Documents = std::span<const BvhDocument>;

/// A message stays readable: so many lines, names in a line and joints of each kind of difference.
constexpr std::size_t kMostLines = 12;
constexpr std::size_t kMostNames = 4;
constexpr std::size_t kMostJoints = 8;

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::optional<std::string> faultInClip(const BvhDocument& document) {
  if (auto fault = faultIn(document.skeleton)) return fault;
  if (auto fault = faultIn(document.skeleton, document.clip)) return fault;
  if (document.clip.frameCount() == 0) return "a clip without frames";
  return {};
}

/// Lines below a heading, cut to kMostLines; `left` are clips behind the lines cut.
std::string withLines(std::string heading, const std::vector<std::string>& lines, std::size_t clipsLeft) {
  const std::size_t shown = std::min(lines.size(), kMostLines);
  for (std::size_t k = 0; k < shown; ++k) heading += "\n  " + lines[k];
  if (shown < lines.size()) heading += fmt::format("\n  and {}", counted(clipsLeft, "more clip"));
  return heading;
}

std::optional<Error> faultInValues(Documents clips) {
  std::vector<std::string> lines;
  std::optional<Error> first;
  for (const BvhDocument& document : clips) {
    const auto fault = faultInClip(document);
    if (!fault) continue;
    if (!first) first = Error{ErrorCode::kInvalidArgument, *fault, {document.clip.name}};
    lines.push_back(fmt::format("{}: {}", document.clip.name, *fault));
  }
  if (lines.size() < 2) return first;
  return Error{ErrorCode::kInvalidArgument,
               withLines(fmt::format("{} of {} clips cannot be used:", lines.size(), clips.size()), lines,
                         lines.size() - std::min(lines.size(), kMostLines))};
}

/// Clips that have one skeleton.
struct SkeletonGroup {
  const Skeleton* skeleton = nullptr;
  std::vector<std::string> names;
};

/// By the first clip of each group.
std::vector<SkeletonGroup> groupsOf(Documents clips) {
  std::vector<SkeletonGroup> groups;
  for (const BvhDocument& document : clips) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const SkeletonGroup& group) {
      return differenceBetween(*group.skeleton, document.skeleton).empty();
    });
    if (same == groups.end()) {
      groups.push_back({&document.skeleton, {document.clip.name}});
    } else {
      same->names.push_back(document.clip.name);
    }
  }
  return groups;
}

std::string namesOf(const SkeletonGroup& group) {
  const std::size_t shown = std::min(group.names.size(), kMostNames);
  std::string text = fmt::format(
      "{}", fmt::join(group.names.begin(), group.names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < group.names.size())
    text += fmt::format(" and {}", counted(group.names.size() - shown, "more clip"));
  return text;
}

/// What is expected, and whose that is.
struct ExpectedSkeleton {
  const Skeleton& skeleton;
  std::string owner;
};

/// The groups other than the expected one, largest first, as one error.
Error mismatch(std::vector<SkeletonGroup> others, const ExpectedSkeleton& expected, std::size_t clipCount) {
  std::stable_sort(others.begin(), others.end(), [](const SkeletonGroup& a, const SkeletonGroup& b) {
    return a.names.size() > b.names.size();
  });
  std::vector<std::string> lines;
  std::size_t clips = 0;
  std::size_t clipsShown = 0;
  for (const SkeletonGroup& group : others) {
    clips += group.names.size();
    if (lines.size() < kMostLines) clipsShown += group.names.size();
    lines.push_back(describe(differencesOf(expected.skeleton, *group.skeleton), kMostJoints));
  }
  if (clips == 1) {
    return {ErrorCode::kSkeletonMismatch,
            fmt::format("its skeleton is not that of {}: {}", expected.owner, lines.front()),
            {others.front().names.front()}};
  }
  for (std::size_t g = 0; g < lines.size(); ++g)
    lines[g] = fmt::format("{}: {}", namesOf(others[g]), lines[g]);
  return {ErrorCode::kSkeletonMismatch,
          withLines(
              fmt::format("{} of {} clips have another skeleton than {}:", clips, clipCount, expected.owner),
              lines, clips - clipsShown)};
}

std::optional<Error> faultInSkeletons(Documents clips) {
  std::vector<SkeletonGroup> groups = groupsOf(clips);
  if (groups.size() < 2) return {};
  const auto most = std::max_element(
      groups.begin(), groups.end(),
      [](const SkeletonGroup& a, const SkeletonGroup& b) { return a.names.size() < b.names.size(); });
  const ExpectedSkeleton expected{
      *most->skeleton, most->names.size() == 1
                           ? most->names.front()
                           : fmt::format("the {} clips like {}", most->names.size(), most->names.front())};
  groups.erase(most);
  return mismatch(std::move(groups), expected, clips.size());
}

}  // namespace

std::optional<Error> faultInClips(Documents clips, const LibraryParams& params) {
  if (clips.empty()) return Error{ErrorCode::kInvalidArgument, "no clips, at least one expected"};
  if (auto error = faultInValues(clips)) return error;
  if (auto error = faultInSkeletons(clips)) return error;
  return faultInAmount(clips, params);
}

std::optional<Error> faultInClips(Documents clips, const MotionLibrary& library) {
  if (clips.empty()) return Error{ErrorCode::kInvalidArgument, "no clips, at least one expected"};
  if (auto error = faultInValues(clips)) return error;
  std::vector<SkeletonGroup> groups = groupsOf(clips);
  std::erase_if(groups, [&](const SkeletonGroup& group) {
    return differenceBetween(library.skeleton, *group.skeleton).empty();
  });
  if (!groups.empty()) return mismatch(std::move(groups), {library.skeleton, "the library"}, clips.size());
  return faultInAmount(clips, library.params, {library.clips.size(), library.frames.frameCount()});
}

}  // namespace stridegraph
