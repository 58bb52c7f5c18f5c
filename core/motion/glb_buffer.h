#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"

namespace tinygltf {
class Model;
}

namespace stridegraph {

/// What the numbers of an accessor are, beside the numbers.
struct GlbAccessor {
  int type = 0;           ///< TINYGLTF_TYPE_...
  int componentType = 0;  ///< TINYGLTF_COMPONENT_TYPE_...
  int target = 0;         ///< What the bytes are bound to in drawing, 0 for none.
  bool isNormalized = false;
  bool hasLimits = false;  ///< State least and greatest value of each component; floats only.
};

/// Appends `bytes`, whose size must be a multiple of 4 and of an element, to the model's only buffer, with a
/// view and an accessor of their own. Returns the accessor's index.
int addGlbAccessor(tinygltf::Model& model, std::span<const std::uint8_t> bytes, const GlbAccessor& accessor);

/// The bytes of numbers, as they lie in memory: little-endian, as glTF wants them.
template <typename T>
std::span<const std::uint8_t> bytesOf(const std::vector<T>& values) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace stridegraph
