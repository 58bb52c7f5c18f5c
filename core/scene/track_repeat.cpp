#include "scene/track_repeat.h"

namespace stridegraph {

std::string_view trackRepeatName(TrackRepeat repeat) {
  switch (repeat) {
    case TrackRepeat::kLoop:
      return "loop";
    case TrackRepeat::kPingPong:
      return "pingpong";
    case TrackRepeat::kOnce:
      return "once";
  }
  return "loop";
}

std::optional<TrackRepeat> trackRepeatFromName(std::string_view name) {
  for (const TrackRepeat repeat : {TrackRepeat::kLoop, TrackRepeat::kPingPong, TrackRepeat::kOnce}) {
    if (trackRepeatName(repeat) == name) return repeat;
  }
  return std::nullopt;
}

}  // namespace stridegraph
