#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// A name that any file may hold: UTF-8 (toUtf8), "_" for each control character, no blanks at its ends, and
/// `fallback` where nothing remains.
std::string exportName(std::string_view name, std::string_view fallback);

/// The names, all different: the first of equal ones stays as it is, further ones get "_2", "_3" ... behind
/// them, whatever nobody else is called.
std::vector<std::string> madeUnique(std::vector<std::string> names);

}  // namespace stridegraph
