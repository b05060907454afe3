// Point clouds with normals: directions with weights, where there is no surface.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Normals of points, or a Gauss map (how much of a surface faces which way), with one weight for each. Only the
/// directions of the normals count: neither their lengths nor which of the two sides they point to.
struct WeightedNormals {
  std::vector<Vector3> normals;
  std::vector<double> weights;  ///< one for each normal, 0 or more
  std::size_t points = 0;       ///< points in the file
  std::size_t dropped = 0;      ///< points left out because their normal is zero or not finite
};

/// Reads the element `vertex` of a PLY file, text or binary: the normal `nx`, `ny`, `nz`, and as weight `weight` or
/// `area` if there is one of these, otherwise 1. Throws MeshError if the file is malformed, is not PLY, has no normals,
/// has no point with a usable normal, or has a weight that is negative or not finite. Thread safe.
WeightedNormals read_normals(const std::filesystem::path& file);

/// The same for bytes in memory; `name` is what errors call the file.
WeightedNormals read_normals(std::string_view bytes, const std::string& name);

}  // namespace rectilin
