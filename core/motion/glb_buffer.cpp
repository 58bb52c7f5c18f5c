#include "motion/glb_buffer.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>

namespace stridegraph {
namespace {

void addLimits(std::span<const std::uint8_t> bytes, std::size_t components, tinygltf::Accessor& accessor) {
  const std::size_t count = bytes.size() / sizeof(float);
  for (std::size_t i = 0; i < count; ++i) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + i * sizeof(float), sizeof(float));
    const auto number = static_cast<double>(value);
    if (i < components) {
      accessor.minValues.push_back(number);
      accessor.maxValues.push_back(number);
    }
    accessor.minValues[i % components] = std::min(accessor.minValues[i % components], number);
    accessor.maxValues[i % components] = std::max(accessor.maxValues[i % components], number);
  }
}

}  // namespace

int addGlbAccessor(tinygltf::Model& model, std::span<const std::uint8_t> bytes,
                   const GlbAccessor& description) {
  STRIDEGRAPH_CHECK(!bytes.empty() && bytes.size() % 4 == 0);
  if (model.buffers.empty()) model.buffers.emplace_back();
  std::vector<unsigned char>& data = model.buffers.front().data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes.size();
  view.target = description.target;
  data.insert(data.end(), bytes.begin(), bytes.end());

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  accessor.componentType = description.componentType;
  accessor.type = description.type;
  accessor.normalized = description.isNormalized;
  const auto components = static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(description.type)));
  const auto componentBytes = static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(description.componentType)));
  accessor.count = bytes.size() / (components * componentBytes);
  if (description.hasLimits) addLimits(bytes, components, accessor);
  model.bufferViews.push_back(std::move(view));
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size() - 1);
}

}  // namespace stridegraph
