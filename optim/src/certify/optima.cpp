#include "certify/optima.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "certify/bounder.h"
#include "certify/branch_and_bound.h"
#include "certify/descent.h"
#include "certify/kink_ball.h"

namespace rectilin::certification {
namespace {

constexpr double kDescendBelow = 0.01;    // local searches start from cells with half-edges below this
constexpr double kFinest = 1e-4;          // cells with half-edges below this are not halved any more
constexpr std::size_t kMostCells = 3000;  // if there are more cells they are not halved any more
constexpr double kLeastBall = 1e-5;       // radians
constexpr int kDescent = 40;
constexpr double kStretched = 0.02;  // radians; a component that extends further is a continuum

/// Cells of equal size that are halved together, until each is excluded, or in the ball of a known minimum, or small.
class Search {
 public:
  Search(Evaluator& evaluator, const CertifyOptions& options, double threshold)
      : evaluator_(evaluator),
        options_(options),
        threshold_(threshold),
        enough_(threshold + rounding_allowance(evaluator.objective().cut_bounds())),
        bounder_(table_, options.bundle) {}

  std::vector<Optimum> run() {
    Candidate zone;
    zone.cell.box = Box::zone();
    open_ = {zone};
    for (int level = 0; !open_.empty() && !evaluator_.exhausted(); ++level) {
      evaluate();
      std::erase_if(open_, [this](const Candidate& c) { return c.cell.bound >= enough_; });
      const double half_edge = zone.cell.box.half_edges()[0] / static_cast<double>(1 << (level / 3));
      if (half_edge < kDescendBelow) find_minima();
      if (half_edge < kFinest || open_.size() > kMostCells) break;
      halve(level % 3);
    }
    cut_short_ = evaluator_.exhausted();
    collect_components();
    std::ranges::stable_sort(found_, {}, &Optimum::value);
    return std::move(found_);
  }

 private:
  struct Candidate {
    Cell cell;
    bool descended = false;
  };

  /// Takes cuts at the minima of the models of the cells where the model is too low, all in one batch.
  void evaluate() {
    std::vector<Rotation> rotations;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (open_[i].cell.model >= enough_) continue;
      owners.push_back(i);
      rotations.push_back(rotation_from_rodrigues(open_[i].cell.low_point));
    }
    std::vector<Cut> cuts(rotations.size());
    evaluator_.cuts(rotations, cuts);
    const std::size_t first = table_.size();
    for (std::size_t i = 0; i < cuts.size(); ++i) table_.add(rotations[i], cuts[i]);
    tbb::parallel_for(std::size_t{0}, owners.size(), [&](std::size_t j) {
      Cell& cell = open_[owners[j]].cell;
      for (std::size_t k = 0; k < 3; ++k)
        cell.bundles[k].add(static_cast<std::uint32_t>(first + 3 * j + k), options_.bundle);
      bounder_.raise(cell, enough_);
    });
  }

  /// Runs a local search from each cell; a minimum with a ball of its own removes the cells inside that ball.
  void find_minima() {
    const Generators generators = evaluator_.objective().generators();
    if (generators.size() == 0) return;
    for (Candidate& candidate : open_) {
      if (candidate.descended || balls_.hold(candidate.cell.box)) continue;
      candidate.descended = true;
      const Rotation start = rotation_from_rodrigues(candidate.cell.low_point);
      const Incumbent minimum = descend(evaluator_, start, evaluator_.cut(start), kDescent, kWideSearch, 0);
      if (!(minimum.value <= threshold_)) continue;
      const double angle = kink_ball(generators, minimum.rotation, minimum.value - 10 * kBallRounding);
      if (angle < kLeastBall || is_known(minimum.rotation, angle)) continue;
      balls_.add(minimum.rotation, angle);
      centres_.push_back({minimum.rotation, angle});
      found_.push_back({Optimum::Kind::kPoint, reduce_to_zone(minimum.rotation), minimum.value});
    }
    std::erase_if(open_, [this](const Candidate& c) { return balls_.hold(c.cell.box); });
  }

  bool is_known(const Rotation& rotation, double angle) const {
    return std::ranges::any_of(centres_, [&](const Centre& centre) {
      return frame_angle(rotation, centre.rotation) < std::max(angle, centre.angle);
    });
  }

  void halve(int axis) {
    std::vector<Candidate> halves(2 * open_.size());
    tbb::parallel_for(std::size_t{0}, halves.size(), [&](std::size_t i) {
      Candidate& half = halves[i] = open_[i / 2];
      half.cell.box = half.cell.box.half(axis, static_cast<int>(i % 2));
      if (half.cell.box.meets_zone() && !balls_.hold(half.cell.box)) bounder_.raise(half.cell, enough_);
      else half.cell.bound = enough_;
    });
    std::erase_if(halves, [this](const Candidate& c) { return c.cell.bound >= enough_; });
    open_ = std::move(halves);
  }

  /// A cell that is left, or a minimum, before it becomes part of a connected component.
  struct Piece {
    Rotation centre;
    Incumbent best;
  };

  /// Joins the pieces that touch into components. Pieces also touch across the faces of the zone, where the same frames
  /// appear as other rotations.
  void collect_components() {
    std::vector<Piece> pieces;
    for (const Optimum& o : found_) pieces.push_back({o.rotation, {o.rotation, o.value}});
    pieces.push_back({evaluator_.incumbent().rotation, evaluator_.incumbent()});
    for (const Candidate& c : open_) {
      const Rotation low = rotation_from_rodrigues(c.cell.low_point);
      pieces.push_back({rotation_from_rodrigues(c.cell.box.centre()), {low, evaluator_.value(low)}});
    }
    found_.clear();
    // Near the identity a cell with half-edges e is 4 |e| wide in radians, elsewhere less.
    const double width = 4 * (open_.empty() ? kFinest : open_[0].cell.box.half_edges().norm());

    std::vector<std::size_t> root(pieces.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&root](std::size_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const auto [low, high] = std::minmax({find(i), find(j)});
            low != high && frame_angle(pieces[i].centre, pieces[j].centre) <= width)
          root[high] = low;
    for (std::size_t r = 0; r < pieces.size(); ++r) {
      if (find(r) != r) continue;
      std::vector<Piece> component;
      for (std::size_t i = r; i < pieces.size(); ++i)
        if (find(i) == r) component.push_back(pieces[i]);
      found_.push_back(describe(component));
    }
  }

  Optimum describe(const std::vector<Piece>& component) const {
    double length = 0;
    for (const Piece& piece : component) length = std::max(length, frame_angle(piece.centre, component[0].centre));
    const Piece& best = *std::ranges::min_element(component, {}, [](const Piece& p) { return p.best.value; });
    Optimum optimum{Optimum::Kind::kPossible, reduce_to_zone(best.best.rotation), best.best.value};
    if (optimum.value <= threshold_ && length <= kStretched) optimum.kind = Optimum::Kind::kPoint;
    else if (optimum.value <= threshold_ && !cut_short_) optimum.kind = Optimum::Kind::kContinuum;
    return optimum;
  }

  struct Centre {
    Rotation rotation;
    double angle;
  };

  Evaluator& evaluator_;
  const CertifyOptions& options_;
  double threshold_, enough_;
  CutTable table_;
  Bounder bounder_;
  std::vector<Candidate> open_;
  Balls balls_;
  std::vector<Centre> centres_;
  std::vector<Optimum> found_;
  bool cut_short_ = false;  // the budget ended before the cells were small
};

}  // namespace

std::vector<Optimum> find_optima(Evaluator& evaluator, const CertifyOptions& options, double threshold) {
  return Search(evaluator, options, threshold).run();
}

}  // namespace rectilin::certification
