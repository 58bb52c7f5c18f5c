#pragma once

#include <cstddef>
#include <string_view>

#include "base/error.h"

namespace stridegraph {

/// Line and column of a byte of a text; of its end where the offset lies beyond. Columns count bytes. `name`
/// becomes the place's file.
Place placeInText(std::string_view text, std::size_t offset, std::string_view name);

}  // namespace stridegraph
