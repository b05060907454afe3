// Points spread over a surface, evenly by area.
#pragma once

#include <cstddef>
#include <vector>

#include "surface.h"

namespace rectilin::pose {

struct Samples {
  std::vector<Vector3> points, normals;
  double patch = 0;  ///< radius of the disc whose area is a sample's share of the surface

  std::size_t size() const { return points.size(); }
};

/// `count` points of the surface, none of them random: sample k stands for the k-th part of the area, the triangles in
/// the order given, and lies in its triangle at the k-th point of a sequence that fills it evenly (Roberts's R2, from
/// the plastic number). So the samples of a mesh that was turned, moved or scaled are turned, moved or scaled with it.
Samples sample_surface(const Surface& surface, std::size_t count);

}  // namespace rectilin::pose
