#include "base/error.h"

namespace stridegraph {
namespace {

std::string withPlace(const Place& place, const std::string& message) {
  const std::string where = describe(place);
  return where.empty() ? message : where + ": " + message;
}

}  // namespace

std::string_view errorCodeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBvhSyntax:
      return "bvh_syntax";
    case ErrorCode::kBvhValue:
      return "bvh_value";
    case ErrorCode::kSkeletonMismatch:
      return "skeleton_mismatch";
    case ErrorCode::kInvalidArgument:
      return "invalid_argument";
    case ErrorCode::kClipTooShort:
      return "clip_too_short";
    case ErrorCode::kEmptyGraph:
      return "empty_graph";
    case ErrorCode::kAssetDamaged:
      return "asset_damaged";
    case ErrorCode::kAssetVersion:
      return "asset_version";
    case ErrorCode::kSceneSyntax:
      return "scene_syntax";
    case ErrorCode::kSceneValue:
      return "scene_value";
    case ErrorCode::kLinkDamaged:
      return "link_damaged";
    case ErrorCode::kLinkVersion:
      return "link_version";
    case ErrorCode::kFile:
      return "file";
  }
  return "unknown";
}

std::string_view warningTopicName(WarningTopic topic) {
  switch (topic) {
    case WarningTopic::kOther:
      return "other";
    case WarningTopic::kText:
      return "text";
    case WarningTopic::kRows:
      return "rows";
    case WarningTopic::kTime:
      return "time";
    case WarningTopic::kTravel:
      return "travel";
    case WarningTopic::kSkeleton:
      return "skeleton";
    case WarningTopic::kUnit:
      return "unit";
    case WarningTopic::kUpAxis:
      return "up_axis";
    case WarningTopic::kMotion:
      return "motion";
    case WarningTopic::kGraph:
      return "graph";
    case WarningTopic::kScene:
      return "scene";
  }
  return "unknown";
}

std::string describe(const Place& place) {
  std::string text = place.file;
  if (place.line == 0) return text;
  if (!text.empty()) text += ':';
  text += std::to_string(place.line);
  if (place.column != 0) text += ':' + std::to_string(place.column);
  return text;
}

std::string describe(const Error& error) {
  return withPlace(error.place, error.message);
}

std::string describe(const Warning& warning) {
  return withPlace(warning.place, warning.message);
}

}  // namespace stridegraph
