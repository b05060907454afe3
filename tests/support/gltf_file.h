// glTF files made for tests: a unit cube, and what is done to it.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "rectilin/base/parameters.h"

namespace rectilin::test {

template <class Number>
void append_raw(std::string& bytes, Number x) {
  std::array<char, sizeof x> raw;
  std::memcpy(raw.data(), &x, sizeof x);
  bytes.append(raw.data(), raw.size());
}

/// Eight corners in single precision, at byte 0, and 36 indices of 16 bits, at byte 96.
inline std::string cube_buffer() {
  std::string bytes;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {4, 2, 1}) append_raw(bytes, (i & bit) ? 1.0f : 0.0f);
  for (const int i :
       {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3})
    append_raw(bytes, static_cast<std::uint16_t>(i));
  return bytes;
}

inline Json cube_json() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
    "buffers": [{"byteLength": 168}]})");
}

inline std::string glb(const Json& json, std::string buffer) {
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  buffer.append((4 - buffer.size() % 4) % 4, '\0');
  std::string bytes = "glTF";
  append_raw(bytes, std::uint32_t{2});
  append_raw(bytes, static_cast<std::uint32_t>(28 + text.size() + buffer.size()));
  append_raw(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  append_raw(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

}  // namespace rectilin::test
