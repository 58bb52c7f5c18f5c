#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// What the joint on the other side may be called: `name` with one mark of its side swapped. Marks are the
/// words left and right in any case anywhere, and the letters l and r at the beginning, at the end, or
/// between separators: LeftArm, upleg_right, lfemur, LThigh, hand.L, "Bip01 R Foot". Whether a joint of such
/// a name exists is for the caller to see: "lowerback" has a suggestion too. Likelier ones come first.
std::vector<std::string> mirroredNames(std::string_view name);

}  // namespace stridegraph
