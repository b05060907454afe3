#include "claims/paper_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <vector>

#include "rectilin/base/symmetric.h"
#include "rectilin/optim/domain.h"

namespace rectilin::paper::claims {
namespace {

struct Cell {
  Vector3 centre;  // alpha, beta, gamma
  Vector3 half;
  double lower;
  std::uint64_t number;  // of cells with equal bounds the older one comes first

  bool operator<(const Cell& other) const { return lower != other.lower ? lower > other.lower : number > other.number; }
  double radius() const { return std::hypot(half[0] + half[2], half[1]); }
};

double bound(const Cut& cut, const Rotation& at, double radius) {
  if (radius > std::numbers::pi / 2) return 1;  // eq. (12)
  const Eigen::Matrix3d b = at.matrix() * cut.gradient.transpose();
  const double w = turning_gradient(cut.gradient, at).norm();
  return cut.value - std::sin(radius) * w - (1 - std::cos(radius)) * (cut.value - symmetric_eigenvalues(b)[0]);
}

class Search {
 public:
  Search(const Objective& objective, double gap) : objective_(objective), gap_(gap) {}

  Enclosure run(int cells) {
    const double quarter = std::numbers::pi / 4;
    add({{Vector3::Constant(quarter), Vector3::Constant(quarter), 1, 0}});
    while (!open_.empty() && static_cast<int>(count_) < cells && gap() > gap_) {
      std::vector<Cell> parts;
      for (int i = 0; i < kRound && !open_.empty(); ++i) {
        divide(open_.top(), parts);
        open_.pop();
      }
      add(std::move(parts));
    }
    best_.lower = std::min(best_.found, closed_);
    if (!open_.empty()) best_.lower = std::min(best_.lower, open_.top().lower);
    best_.lower -= kRounding;
    return best_;
  }

 private:
  static constexpr int kRound = 16;
  static constexpr double kRounding = 1e-11;  // of values, cuts and bounds

  double gap() const { return rectilinearity(open_.top().lower) - rectilinearity(best_.found); }

  void divide(const Cell& cell, std::vector<Cell>& parts) {
    const Vector3 half = cell.half / 2;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      parts.push_back({cell.centre + signs.cwiseProduct(half), half, cell.lower, ++count_});
    }
  }

  void add(std::vector<Cell> cells) {
    std::vector<Rotation> rotations;
    for (const Cell& cell : cells) rotations.push_back(paper_domain().rotation(cell.centre));
    std::vector<Cut> cuts(cells.size());
    objective_.cuts(rotations, cuts);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cuts[i].value < best_.found) improve(rotations[i], cuts[i].value);
      cells[i].lower = std::max(cells[i].lower, bound(cuts[i], rotations[i], cells[i].radius()));
    }
    for (const Cell& cell : cells)
      if (rectilinearity(cell.lower) - rectilinearity(best_.found) > gap_) open_.push(cell);
      else closed_ = std::min(closed_, cell.lower);
  }

  /// Improves a rotation by turns about the third axis: they stay in the box, up to quarter turns, and the best one
  /// costs only a sort.
  void improve(const Rotation& rotation, double value) {
    best_.rotation = rotation;
    best_.found = value;
    if (!objective_.has_turns()) return;
    const BestTurn turn = objective_.best_turn(rotation, 2);
    if (turn.value < value) best_.rotation = turn.rotation, best_.found = turn.value;
  }

  const Objective& objective_;
  double gap_;
  std::priority_queue<Cell> open_;
  std::uint64_t count_ = 0;
  double closed_ = std::numeric_limits<double>::infinity();  // least bound of the cells that are done
  Enclosure best_{.found = std::numeric_limits<double>::infinity()};
};

}  // namespace

bool in_paper_box(const Rotation& rotation) {
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = rotation.axis(k).cwiseProduct(Vector3(1, -1, 1));
    if (axis.minCoeff() >= 0 || axis.maxCoeff() <= 0) return true;
  }
  return false;
}

Enclosure enclose_on_paper_box(const Objective& objective, double gap, int cells) {
  return Search(objective, gap).run(cells);
}

}  // namespace rectilin::paper::claims
