#include "rectilin/base/symmetric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace rectilin {

SymmetricEigen symmetric_eigen(const Eigen::Matrix3d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(0.5 * (m + m.transpose()), Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& m, const Eigen::VectorXd& right) {
  return m.ldlt().solve(right);
}

}  // namespace rectilin
