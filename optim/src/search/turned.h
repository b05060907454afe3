#pragma once

#include "rectilin/base/rotation.h"

namespace rectilin {

/// rotation_from_vector(turn) * rotation, made orthonormal, so that long chains of turns stay so.
inline Rotation turned(const Rotation& rotation, const Eigen::Vector3d& turn) {
  return Rotation::from_quaternion((rotation_from_vector(turn) * rotation).quaternion());
}

}  // namespace rectilin
