#pragma once

#include <span>
#include <string>

namespace stridegraph {

/// Names as a sentence lists them: `"a"`, `"a" and "b"`, `"a", "b" and "c"`, and from the fifth name on
/// `"a", "b", "c" and 2 more`. Empty without names.
std::string quotedNames(std::span<const std::string> names);

}  // namespace stridegraph
