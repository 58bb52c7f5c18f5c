#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// Why something was refused. The one list of codes: names for reports and for JavaScript come from
/// errorCodeName(), nowhere else.
enum class ErrorCode {
  kBvhSyntax,         ///< The BVH text breaks the grammar.
  kBvhValue,          ///< A value in a BVH text is not a finite number or lies out of range.
  kSkeletonMismatch,  ///< Clips of one library have different skeletons.
  kInvalidArgument,   ///< An option lies out of its range.
  kClipTooShort,      ///< No clip is long enough to compare and connect.
  kEmptyGraph,        ///< Nothing survives pruning: no walk could go on for ever.
  kAssetDamaged,      ///< An .sgraph file is truncated, altered or not one at all.
  kAssetVersion,      ///< An .sgraph file was written by a newer or an incompatible program.
  kSceneSyntax,       ///< A scene text is not JSON.
  kSceneValue,        ///< A member of a scene is missing, has the wrong type or lies out of range.
  kLinkDamaged,       ///< A link's text is broken: its checksum does not hold.
  kLinkVersion,       ///< A link was made by a newer program.
  kFile,              ///< A file cannot be read or written (only programs say this; core opens none).
};

/// Every code, in order, for those who mirror the list (the JavaScript module does).
inline constexpr std::array kAllErrorCodes = {
    ErrorCode::kBvhSyntax,
    ErrorCode::kBvhValue,
    ErrorCode::kSkeletonMismatch,
    ErrorCode::kInvalidArgument,
    ErrorCode::kClipTooShort,
    ErrorCode::kEmptyGraph,
    ErrorCode::kAssetDamaged,
    ErrorCode::kAssetVersion,
    ErrorCode::kSceneSyntax,
    ErrorCode::kSceneValue,
    ErrorCode::kLinkDamaged,
    ErrorCode::kLinkVersion,
    ErrorCode::kFile,
};

/// The code's name in reports and in JavaScript, lower snake case: "bvh_syntax".
std::string_view errorCodeName(ErrorCode code);

/// A place in a text. Lines and columns count from 1; 0 means unknown.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// A foreseeable failure: what was found, what was expected and where.
struct Error {
  ErrorCode code = ErrorCode::kInvalidArgument;
  std::string message;  ///< One sentence that names found and expected, without the place.
  Place place = {};
};

/// What a warning is about; clients group warnings by it.
enum class WarningTopic {
  kOther,
  kText,      ///< Encoding and names.
  kRows,      ///< Rows of numbers and how many there are.
  kTime,      ///< Frame times and rates.
  kTravel,    ///< The joint whose path is the body's.
  kSkeleton,  ///< Offsets and channels of joints.
  kUnit,      ///< The unit of lengths.
  kUpAxis,    ///< The axis that points up.
  kMotion,    ///< Captured frames: glitches, cuts, the floor.
  kGraph,     ///< What of the clips the motion graph holds.
  kScene,     ///< Members of a scene.
};

/// Every topic, in order, for those who mirror the list (the JavaScript module does).
inline constexpr std::array kAllWarningTopics = {
    WarningTopic::kOther,  WarningTopic::kText,     WarningTopic::kRows,  WarningTopic::kTime,
    WarningTopic::kTravel, WarningTopic::kSkeleton, WarningTopic::kUnit,  WarningTopic::kUpAxis,
    WarningTopic::kMotion, WarningTopic::kGraph,    WarningTopic::kScene,
};

/// The topic's name in reports and in JavaScript, lower snake case: "up_axis".
std::string_view warningTopicName(WarningTopic topic);

/// Odd but usable input: shown to the user beside the result.
struct Warning {
  std::string message;
  Place place = {};
  WarningTopic topic = WarningTopic::kOther;
};
using Warnings = std::vector<Warning>;

/// "file:line:column", the parts that are known; empty when nothing is.
std::string describe(const Place& place);

/// "file:line:column: message", as programs print it.
std::string describe(const Error& error);
std::string describe(const Warning& warning);

}  // namespace stridegraph
