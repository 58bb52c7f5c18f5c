#pragma once

#include <string_view>

/// The colours of all pictures, those of the page where it has one for the same thing. Pictures bring their
/// own paper, so that they are as legible on a dark page as on a light one.
namespace stridegraph::figures::palette {

inline constexpr std::string_view kPaper = "#fbfaf7";
inline constexpr std::string_view kInk = "#1a2433";
inline constexpr std::string_view kQuiet = "#5b6778";
inline constexpr std::string_view kFaint = "#d9dde3";
inline constexpr std::string_view kFrame = "#a9b2bf";
inline constexpr std::string_view kFloor = "#f1efe9";
inline constexpr std::string_view kBlock = "#8fa1b8";
inline constexpr std::string_view kGrown = "#dfe4eb";
inline constexpr std::string_view kCaptured = "#d9622b";  ///< Frames as captured, and the walk's root.
inline constexpr std::string_view kBlended = "#6a56cf";   ///< Frames of transitions.
inline constexpr std::string_view kPath = "#2563d9";
inline constexpr std::string_view kRoadmap = "#8796aa";
inline constexpr std::string_view kLeft = "#1f8a8a";
inline constexpr std::string_view kRight = "#b04a78";
inline constexpr std::string_view kStart = "#15805a";
inline constexpr std::string_view kGoal = "#c4303f";

}  // namespace stridegraph::figures::palette
