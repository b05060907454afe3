// Eigenvalues of symmetric matrices. Eigen's solver is compiled here, once: a source that uses it compiles for a second
// longer.
#pragma once

#include <Eigen/Core>

namespace rectilin {

struct SymmetricEigen {
  Eigen::Vector3d values;   ///< ascending
  Eigen::Matrix3d vectors;  ///< column k is a unit vector that belongs to values[k]
};

/// `m` is symmetric: only its lower triangle is read. An entry that is not finite gives values that are not.
SymmetricEigen symmetric_eigen(const Eigen::Matrix3d& m);

/// The eigenvalues of the symmetric part (m + m^T) / 2 of any matrix, ascending.
Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& m);

}  // namespace rectilin
