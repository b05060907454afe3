// What the formats with a scene graph share: placing meshes, and a bound on what placing them may cost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// A file of a few kilobytes can place one mesh a million times in a scene, and scenes in scenes. So the cost of a
/// scene, in vertices and triangles, is counted before anything is placed.
class SceneCost {
 public:
  /// What instances may come to, unless the file itself holds more than that.
  static constexpr std::uint64_t kPlaced = std::uint64_t{1} << 25;
  /// What placing a mesh costs beside its vertices and triangles: a transform is about so many of them.
  static constexpr std::uint64_t kInstance = 16;

  /// Sums that cannot overflow: from this on everything is too much.
  static constexpr std::uint64_t kTooMuch = std::uint64_t{1} << 60;
  static std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return std::min(kTooMuch, a + b); }

  /// Throws MeshError if `placed` is too much for a file that holds `stored` vertices and triangles.
  static void check(std::uint64_t placed, std::uint64_t stored, const std::string& name) {
    if (placed > std::max(kPlaced, stored))
      throw MeshError(name + ": its instances come to more than " + std::to_string(kPlaced) +
                      " vertices and triangles");
  }
};

}  // namespace rectilin
