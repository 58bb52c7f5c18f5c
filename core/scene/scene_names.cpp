#include "scene/scene_names.h"

#include <array>
#include <cstddef>

namespace stridegraph {

namespace {

// In the order of the enumerations.
constexpr std::array<std::string_view, 3> kTrackRepeats = {"loop", "pingpong", "once"};
constexpr std::array<std::string_view, 2> kGaits = {"walk", "run"};
constexpr std::array<std::string_view, 2> kAreaKinds = {"avoid", "prefer"};

template <typename Enum, std::size_t count>
std::optional<Enum> fromName(const std::array<std::string_view, count>& names, std::string_view name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (names.at(i) == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace

std::string_view trackRepeatName(TrackRepeat repeat) {
  return kTrackRepeats.at(static_cast<std::size_t>(repeat));
}

std::optional<TrackRepeat> trackRepeatFromName(std::string_view name) {
  return fromName<TrackRepeat>(kTrackRepeats, name);
}

std::string_view gaitName(Gait gait) {
  return kGaits.at(static_cast<std::size_t>(gait));
}

std::optional<Gait> gaitFromName(std::string_view name) {
  return fromName<Gait>(kGaits, name);
}

std::string_view areaKindName(AreaKind kind) {
  return kAreaKinds.at(static_cast<std::size_t>(kind));
}

std::optional<AreaKind> areaKindFromName(std::string_view name) {
  return fromName<AreaKind>(kAreaKinds, name);
}

}  // namespace stridegraph
