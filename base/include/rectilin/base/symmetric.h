// Eigenvalues of symmetric matrices, and linear equations. Eigen's solvers are compiled here, once: a source that uses
// one of them compiles for one to seven seconds longer.
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

/// The x with m x = right, for a symmetric m of any size without negative eigenvalues; what it leaves open if `m` is
/// singular is chosen by Eigen's LDLT.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& m, const Eigen::VectorXd& right);

}  // namespace rectilin
