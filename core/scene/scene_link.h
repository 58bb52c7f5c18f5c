#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace stridegraph {

/// What a link holds: enough to replay the same walk anywhere.
struct SharedScene {
  Scene scene;
  std::string search = "guided";  ///< Name of the motion search.
  std::uint64_t libraryHash = 0;  ///< Of the library it was planned with; 0 when unknown.
};

/// The fragment of a link without '#': "s=" and a versioned, checksummed text of URL-safe letters.
std::string encodeLink(const SharedScene& shared);

/// Reads a fragment, with or without '#'. Fails with kLinkDamaged or kLinkVersion and a sentence for users.
Result<SharedScene> decodeLink(std::string_view fragment);

}  // namespace stridegraph
