#include "certify/bounder.h"

#include "certify/box_bound.h"
#include "rectilin/base/rotation.h"

namespace rectilin::certification {

PerCut<double> Bounder::raise(Cell& cell, double enough) const {
  const Corners corners(cell.box);
  CornerGame game;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < cell.bundles[k].size; ++j) game.add(k, corners.along(k, slope(cell, k, j)));
  const Strategies strategies = solve(game, enough);

  Eigen::Matrix3d mixture = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < game.size[k]; ++j) {
      const double weight = strategies.weight[k][j];
      if (weight == 0) continue;
      mixture.row(k) += weight * slope(cell, k, j).transpose();
    }
  Array8 values = Array8::Zero();
  for (int k = 0; k < 3; ++k) values += corners.along(k, mixture.row(k));
  cell.bound = std::max(cell.bound, box_bound(mixture, values, cell.box));
  if (!(cell.bound >= enough)) describe(cell, corners, strategies, values);
  return strategies.weight;
}

void Bounder::describe(Cell& cell, const Corners& corners, const Strategies& strategies, const Array8& values) const {
  for (int i = 0; i < 3; ++i) cell.low_point[i] = (strategies.corner * corners.rho[i]).sum();
  const Rotation low = rotation_from_rodrigues(cell.low_point);
  cell.model = 0;
  for (int k = 0; k < 3; ++k) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (int j = 0; j < cell.bundles[k].size; ++j)
      greatest = std::max(greatest, slope(cell, k, j).dot(low.matrix().row(k)));
    cell.model += greatest;
  }

  // Halving an edge of half length e halves the mixture's slope along it, and a quarter of the curvature's loss
  // is left, which is 4/3 value e^2: the corner matrices' convex hull is that far from the rotations.
  const Eigen::Vector3d e = cell.box.half_edges();
  for (int i = 0; i < 3; ++i)
    cell.spread[i] =
        static_cast<float>(std::abs((kCornerSigns[i] * values).sum()) / 8 + 4.0 / 3 * cell.bound * e[i] * e[i]);

  for (int k = 0; k < 3; ++k) {
    Cell::Bundle& bundle = cell.bundles[k];
    const Cell::Bundle before = bundle;
    int at = 0;
    for (const bool useful : {true, false})
      for (int j = 0; j < before.size; ++j)
        if ((strategies.weight[k][j] > 1e-9) == useful) bundle.cuts[at++] = before.cuts[j];
  }
}

}  // namespace rectilin::certification
