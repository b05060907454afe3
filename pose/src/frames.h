// Small helpers on frames.
#pragma once

#include "rectilin/base/rotation.h"

namespace rectilin::pose {

/// The rotation with these rows, the last one turned around if that makes it proper.
Rotation frame_of(Eigen::Matrix3d rows);

/// Point i of `count` of a Fibonacci spiral over the hemisphere z >= 0, spread evenly.
Eigen::Vector3d hemisphere_point(int i, int count);

/// The angle between two lines through the origin, in [0, pi/2]; unit vectors.
double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace rectilin::pose
