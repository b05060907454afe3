// Ceres as an optimizer of this project.
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <ceres/manifold.h>

#include <algorithm>
#include <cmath>

#include "graduated.h"
#include "rectilin/optim/adapters/all_optimizers.h"

namespace rectilin {
namespace {

struct CeresOptions {
  int starts = 0;
  int iterations = 100;
  Graduation graduation = {};
  void bind(Parameters& table);
};

/// The smooth surrogate as a function of a unit quaternion (x, y, z, w), as Ceres wants it.
class Surrogate final : public ceres::FirstOrderFunction {
 public:
  Surrogate(Evaluator& evaluator, double width) : evaluator_(evaluator), width_(width) {}

  int NumParameters() const override { return 4; }

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    if (evaluator_.remaining() < Costs::kPerSmooth + Costs::kPerValue)
      return false;  // one evaluation is kept for the end point
    const Eigen::Quaterniond q(parameters);
    const Rotation rotation = Rotation::from_quaternion(q);
    const SmoothValue smooth = evaluator_.smooth(rotation, width_);
    if (!std::isfinite(smooth.value)) return false;
    *cost = smooth.value;
    if (gradient) {
      // Ceres moves q to (d, 1) q, which is a turn by 2d, and the directions (e_i, 0) q are orthonormal, so this is the
      // gradient on the manifold in that basis.
      const Eigen::Vector3d slope = 2 * turning_gradient(smooth.gradient, rotation);
      const Eigen::Quaterniond ambient = Eigen::Quaterniond(0, slope.x(), slope.y(), slope.z()) * q;
      std::copy_n(ambient.coeffs().data(), 4, gradient);
    }
    return true;
  }

 private:
  Evaluator& evaluator_;
  double width_;
};

void CeresOptions::bind(Parameters& table) {
  bind_starts(table, starts,
              "descents: the first from the incumbent, if there is one, the others from random rotations");
  table.integer("iterations", iterations, 1, 1000000, "largest number of L-BFGS iterations in each round");
  graduation.bind(table);
}

void descend(const CeresOptions& options, const Rotation& start, Evaluator& evaluator, const Domain&, Random&) {
  // Evaluate the true objective once, so that an interrupted run still has an incumbent.
  if (!evaluator.has_incumbent()) evaluator.value(start);
  Eigen::Quaterniond q = start.quaternion();
  ceres::GradientProblemSolver::Options solver;
  solver.logging_type = ceres::SILENT;
  solver.max_num_iterations = options.iterations;
  solver.function_tolerance = 1e-12;
  for (int round = 0; round < options.graduation.rounds && !evaluator.exhausted(); ++round) {
    const ceres::GradientProblem problem(new Surrogate(evaluator, options.graduation.at(round)),
                                         new ceres::EigenQuaternionManifold);  // owned by the problem
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(solver, problem, q.coeffs().data(), &summary);
    evaluator.value(Rotation::from_quaternion(q));
  }
}

}  // namespace

void add_ceres(Registry& registry) {
  registry.add(LocalMethod<CeresOptions>{.name = "ceres",
                                         .help = "Ceres' L-BFGS on the smooth surrogate, on the manifold of rotations",
                                         .capabilities = {.uses_domain = false, .needs_smooth = true},
                                         .improve = descend,
                                         .starts = &CeresOptions::starts});
}

}  // namespace rectilin
