#include "certify/bounder.h"

#include "certify/box_bound.h"
#include "rectilin/base/rotation.h"

namespace rectilin::certification {
namespace {

constexpr int kMostLoans = 2;        // how often cuts are borrowed for one cell
constexpr double kLeastGain = 0.03;  // a borrowed cut has to raise the model by this fraction of what the bound lacks

}  // namespace

Bounder::Bound Bounder::mix(const Cell& cell, double enough) const {
  const Mixture best = mixture(cell, Corners(cell.box), enough);
  return {best.strategies.weight, best.bound};
}

PerCut<double> Bounder::raise(Cell& cell, double enough) const {
  const Corners corners(cell.box);
  Mixture best = mixture(cell, corners, enough);
  for (int loan = 0; best.bound < enough && loan < kMostLoans && borrow(cell, corners, best, enough); ++loan) {
    cell.bound = std::max(cell.bound, best.bound);
    best = mixture(cell, corners, enough);
  }
  cell.bound = std::max(cell.bound, best.bound);
  if (!(cell.bound >= enough)) describe(cell, corners, best);
  return best.strategies.weight;
}

Bounder::Mixture Bounder::mixture(const Cell& cell, const Corners& corners, double enough) const {
  CornerGame game;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < cell.bundles[k].size; ++j) game.add(k, corners.along(k, slope(cell, k, j)));
  Mixture best = {.strategies = solve(game, enough)};
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < game.size[k]; ++j) {
      const double weight = best.strategies.weight[k][j];
      if (weight == 0) continue;
      best.form.row(k) += weight * slope(cell, k, j).transpose();
    }
  for (int k = 0; k < 3; ++k) best.values += corners.along(k, best.form.row(k));
  best.bound = box_bound(best.form, best.values, cell.box);
  return best;
}

/// The largest product of the axis' cuts with a vector.
double Bounder::greatest(const Cell& cell, int k, const Eigen::Vector3d& u) const {
  double value = -std::numeric_limits<double>::infinity();
  for (int j = 0; j < cell.bundles[k].size; ++j) value = std::max(value, slope(cell, k, j).dot(u));
  return value;
}

/// The programme's value is the model's value at the mixture of the corners' matrices (not at a rotation: the mixture
/// of an axis is a little shorter than one), whatever the cuts: it is the least there over all mixtures. So only cuts
/// that are greater at this mixture can raise it, and only if they reach `enough` there can they settle the cell.
/// Returns false if no such cuts are known.
bool Bounder::borrow(Cell& cell, const Corners& corners, const Mixture& mixture, double enough) const {
  std::array<CutTable::Found, 3> found;
  std::array<double, 3> gain;
  double model = 0;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d low;
    for (int i = 0; i < 3; ++i) low[i] = (mixture.strategies.corner * corners.entry[3 * k + i]).sum();
    const double before = greatest(cell, k, low);
    found[k] = table_.best(low, before);
    gain[k] = found[k].value - before;
    model += found[k].value;
  }
  if (model < enough) return false;
  const double lacking = enough - mixture.bound;
  put_useful_first(cell, mixture.strategies);
  for (int k = 0; k < 3; ++k)
    if (gain[k] > kLeastGain * lacking) cell.bundles[k].add(found[k].row, capacity_);
  return true;
}

void Bounder::describe(Cell& cell, const Corners& corners, const Mixture& mixture) const {
  for (int i = 0; i < 3; ++i) cell.low_point[i] = (mixture.strategies.corner * corners.rho[i]).sum();
  const Rotation low = rotation_from_rodrigues(cell.low_point);
  cell.model = 0;
  for (int k = 0; k < 3; ++k) cell.model += greatest(cell, k, low.axis(k));

  // Halving an edge of half length e halves the slope of the mixture along it, and leaves a quarter of the loss by
  // curvature, which is 4/3 value e^2: the convex hull of the matrices at the corners is that far from the rotations.
  const Eigen::Vector3d e = cell.box.half_edges();
  for (int i = 0; i < 3; ++i)
    cell.spread[i] =
        static_cast<float>(std::abs((kCornerSigns[i] * mixture.values).sum()) / 8 + 4.0 / 3 * cell.bound * e[i] * e[i]);
  put_useful_first(cell, mixture.strategies);
}

void Bounder::put_useful_first(Cell& cell, const Strategies& strategies) {
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
