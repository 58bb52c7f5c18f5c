#pragma once

#include <string_view>

namespace stridegraph {

/// How the bytes of a text are to be read, as far as its first bytes tell.
enum class BvhEncoding {
  kBytes,  ///< UTF-8, ASCII or an encoding of one byte a character.
  kUtf16LittleEndian,
  kUtf16BigEndian,
  kUtf32,
};

/// Tells by a byte-order mark, else by the zero bytes between the letters of a first word HIERARCHY.
BvhEncoding encodingOf(std::string_view bytes);

/// Names what a file that is no BVH seems to be, by how such files begin: "a gzip archive", "JSON", ... Empty
/// when the bytes begin like none of them. `bytes` may be a file's or its text as UTF-8.
std::string_view otherContentIn(std::string_view bytes);

}  // namespace stridegraph
