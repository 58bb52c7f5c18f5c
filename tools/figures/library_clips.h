#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "graph/library.h"

namespace stridegraph::figures {

/// One of a library's clips, copied out.
Clip clipOf(const MotionLibrary& library, const LibraryClip& clip);

/// The clip of that name; nothing when the library has none.
std::optional<Clip> clipNamed(const MotionLibrary& library, std::string_view name);

/// What a clip does on the whole.
struct ClipManner {
  double speedMetresPerSecond = 0.0;  ///< Of the root, mean.
  Angle turn;                         ///< All in all; growing headings are positive.
};
ClipManner mannerOf(const Clip& clip);

/// The clips that are no mirror images, longest first; of equal ones the first.
std::vector<LibraryClip> clipsByLength(const MotionLibrary& library);

}  // namespace stridegraph::figures
