// Numbers in the buffers of a glTF file (Khronos Group, glTF 2.0 Specification, 2021, section 3.6.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "rectilin/mesh/mesh.h"

namespace tinygltf {
class Model;
}

namespace rectilin {

/// Elements of up to four numbers each. Every offset and count is checked against the buffer when one is made, so
/// reading needs no more checks. Refers to the model.
class GltfAccessor {
 public:
  /// `components` numbers an element are expected. Throws MeshError for anything the file cannot hold.
  GltfAccessor(const tinygltf::Model& model, int index, std::size_t components, const std::string& name);

  std::size_t size() const { return dense_.count; }
  bool is_integer() const { return dense_.type != kFloat; }

  /// Numbers that replace others, element by element.
  std::size_t replaced() const { return indices_.count; }

  /// Calls `take(i, numbers)` for each element, with the first `components` of the numbers set; those that are replaced
  /// come a second time.
  template <class Take>
  void for_each(const Take& take) const {
    for (std::size_t i = 0; i < dense_.count; ++i) take(i, element(dense_, i));
    for (std::size_t i = 0; i < indices_.count; ++i)
      take(static_cast<std::size_t>(element(indices_, i)[0]), element(values_, i));
  }

 private:
  static constexpr int kFloat = 5126;

  struct Span {
    const unsigned char* begin = nullptr;  ///< none: zeros
    std::size_t count = 0, stride = 0, components = 1;
    int type = kFloat;
    bool normalized = false;  ///< integers stand for numbers in [0, 1] or [-1, 1]
  };
  Span span(const tinygltf::Model& model, int view, std::size_t offset, std::size_t count, std::size_t components,
            int type, bool normalized) const;
  std::array<double, 4> element(const Span& span, std::size_t i) const;
  [[noreturn]] void fail(const std::string& reason) const;

  std::string name_;
  int index_;
  Span dense_, indices_, values_;
};

}  // namespace rectilin
