#include "io/gltf_accessor.h"

#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/scene.h"

namespace rectilin {
namespace {

/// Bytes of a component; 0 for types that glTF has not.
std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <class Number>
double number_at(const unsigned char* bytes) {
  std::array<unsigned char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<Number>(raw));
}

double component_at(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double x = number_at<std::int8_t>(bytes);
      return normalized ? std::max(x / 127, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>(bytes) / (normalized ? 255 : 1);
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double x = number_at<std::int16_t>(bytes);
      return normalized ? std::max(x / 32767, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>(bytes) / (normalized ? 65535 : 1);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>(bytes);
    default:
      return number_at<float>(bytes);
  }
}

}  // namespace

GltfAccessor::GltfAccessor(const tinygltf::Model& model, int index, std::size_t components, const std::string& name)
    : name_(name), index_(index) {
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) fail("there is none of this number");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const int found = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (found != static_cast<int>(components)) fail("it has not " + std::to_string(components) + " numbers an element");
  const auto& sparse = accessor.sparse;
  if (accessor.bufferView < 0 && !sparse.isSparse && accessor.count > 0) fail("it has no data");
  dense_ = span(model, accessor.bufferView, accessor.byteOffset, accessor.count, components, accessor.componentType,
                accessor.normalized);
  if (!sparse.isSparse) return;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count || sparse.indices.bufferView < 0 ||
      sparse.values.bufferView < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
    fail("its sparse part is malformed");
  const auto replaced = static_cast<std::size_t>(sparse.count);
  indices_ = span(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), replaced, 1,
                  sparse.indices.componentType, false);
  values_ = span(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), replaced,
                 components, accessor.componentType, accessor.normalized);
  for (std::size_t i = 0; i < replaced; ++i) {
    const double target = element(indices_, i)[0];
    if (!(target >= 0) || target >= static_cast<double>(accessor.count)) fail("a sparse index is out of range");
  }
}

GltfAccessor::Span GltfAccessor::span(const tinygltf::Model& model, int view_index, std::size_t offset,
                                      std::size_t count, std::size_t components, int type, bool normalized) const {
  Span span{nullptr, count, 0, components, type, normalized};
  if (component_size(type) == 0) fail("its component type " + std::to_string(type) + " is unknown");
  if (view_index < 0) {  // zeros that a sparse part replaces: no bytes stand behind them
    if (count > SceneCost::kPlaced) fail("its count is beyond all bounds");
    return span;
  }
  if (static_cast<std::size_t>(view_index) >= model.bufferViews.size()) fail("its buffer view does not exist");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
    fail("its buffer does not exist");
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    fail("its buffer view exceeds the buffer");
  const std::size_t size = components * component_size(type);
  span.stride = view.byteStride > 0 ? view.byteStride : size;
  const bool fits = count == 0 || (offset <= view.byteLength && size <= view.byteLength - offset &&
                                   (count - 1) <= (view.byteLength - offset - size) / span.stride);
  if (!fits) fail("its " + std::to_string(count) + " elements exceed the buffer view");
  span.begin = data.data() + view.byteOffset + (count == 0 ? 0 : offset);
  return span;
}

std::array<double, 4> GltfAccessor::element(const Span& span, std::size_t i) const {
  std::array<double, 4> numbers{};
  if (!span.begin) return numbers;
  const unsigned char* at = span.begin + i * span.stride;
  for (std::size_t k = 0; k < span.components; ++k, at += component_size(span.type))
    numbers[k] = component_at(at, span.type, span.normalized);
  return numbers;
}

void GltfAccessor::fail(const std::string& reason) const {
  throw MeshError(name_ + ":accessor " + std::to_string(index_) + ": " + reason);
}

}  // namespace rectilin
