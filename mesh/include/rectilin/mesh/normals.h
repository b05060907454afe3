// Point clouds with normals: directions with weights instead of a surface.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Normals of points, or a Gauss map: how much of a surface faces which way. One weight a normal; only directions of
/// normals count, not their lengths nor their sides.
struct WeightedNormals {
  std::vector<Vector3> normals;
  std::vector<double> weights;  ///< none is negative
  std::size_t points = 0;       ///< records in the file
  std::size_t dropped = 0;      ///< points left out because their normal is zero or not finite
};

/// Reads the element `vertex` of a PLY file, text or binary: `nx`, `ny`, `nz`, and as weight `weight` or `area` if it
/// has one of these, else 1. Throws MeshError if the file is malformed, is no PLY, has no normals, no point with one,
/// or a weight that is negative or not finite. Thread safe.
WeightedNormals read_normals(const std::filesystem::path& file);

/// The same from bytes in memory; `name` stands for the file in errors.
WeightedNormals read_normals(std::string_view bytes, const std::string& name);

}  // namespace rectilin
