// The file of a glTF scene: its JSON and its buffers. Parsed by tinygltf, which is kept from files and images; what it
// does not check is checked before.
#pragma once

#include <string>
#include <string_view>

#include "io/soup.h"

namespace tinygltf {
class Model;
}

namespace rectilin {

/// Throws MeshError if it is not valid, nested deep, claims buffers that are too large, or needs a decompressor.
tinygltf::Model parse_gltf(std::string_view bytes, const ReadBeside& beside, const std::string& name);

}  // namespace rectilin
