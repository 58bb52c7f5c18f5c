#pragma once

#include <cstring>
#include <type_traits>

namespace stridegraph {

/// The bits of a value as another type of the same size: std::bit_cast, which the WebAssembly compiler's
/// library does not have yet.
template <typename To, typename From>
To bitCast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<From> &&
                std::is_trivially_copyable_v<To>);
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

}  // namespace stridegraph
