#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace stridegraph {

/// An index that cannot be mixed up with an index of another kind.
template <typename Tag>
struct TypedIndex {
  std::uint32_t value = 0;

  constexpr TypedIndex() = default;
  constexpr explicit TypedIndex(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr auto operator<=>(const TypedIndex&) const = default;
};

}  // namespace stridegraph
