// The search itself: rounds of cells, from the heap and back.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "certify/bounder.h"
#include "certify/cell_heap.h"
#include "certify/kink_ball.h"
#include "certify/proof_tree.h"
#include "certify/support_floor.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// The least value of the objective whose merit is within `gap` of that of `value`.
double cutoff_value(const Objective& objective, double value, double gap);

/// The largest such value; infinite if all are.
double threshold_value(const Objective& objective, double value, double gap);

/// What is known of rounding, in the units of the objective: a bound that was computed may be too high by that much.
double rounding_allowance(const CutBounds& bounds);

/// One run. A round takes the cells of least bound, evaluates their cuts in one batch, works on them in parallel, each
/// into a slot of its own, and merges the slots in order: the result does not depend on the number of threads.
class BranchAndBound {
 public:
  /// `proof` may be null; all others must outlive the object.
  BranchAndBound(Evaluator& evaluator, const CertifyOptions& options, ProofTree* proof);

  CertifyResult run();

 private:
  /// What proves a cell's bound, once that is enough: cuts with these weights or, if there are some, floors.
  struct Reason {
    PerCut<double> weight = {};
    std::optional<std::array<double, 3>> floors = {};
  };

  /// A half of a cell.
  struct Part {
    enum class State { kOpen, kDone, kOutside, kInBall };
    State state = State::kOpen;
    Cell cell;
    Reason reason;  // if done
  };

  /// A cell of the round, and what becomes of it.
  struct Slot {
    enum class State { kAgain, kDone, kHalved };
    State state = State::kAgain;
    Cell cell;
    std::optional<std::uint32_t> cuts;  // the first of the three new ones, if it asked for some
    Reason reason;
    int axis = 0;
    std::array<Part, 2> parts;
  };

  bool stopped() const;
  void take_round();
  bool evaluate_round();
  void improve_incumbent(std::span<const Rotation> rotations, std::span<const Cut> cuts, double before);
  void update_cutoff();
  void update_balls();
  bool is_flat() const;
  void update_floors();
  void expand(Slot& slot) const;
  void halve(Slot& slot) const;
  Reason raise(Cell& cell) const;
  void merge(Slot& slot);
  void settle(Cell& cell, const Reason& reason);
  void settle_open_cells();
  void report();

  Evaluator& evaluator_;
  const CertifyOptions& options_;
  ProofTree* proof_;
  const Generators generators_;
  const CutBounds facts_;
  const double allowance_;

  CutTable table_;
  Bounder bounder_;
  CellHeap heap_;
  std::vector<Slot> round_;
  Balls balls_;
  bool balls_are_current_ = false;
  std::uint64_t cells_at_balls_ = 0;  // when they were last made
  std::unique_ptr<SupportFloor> floors_;
  bool flatness_is_known_ = false;
  Random jitter_{1};

  double cutoff_ = std::numeric_limits<double>::infinity();         // certified this high, the gap is closed
  double enough_ = std::numeric_limits<double>::infinity();         // cutoff and allowance: cells are done here
  double least_settled_ = std::numeric_limits<double>::infinity();  // least bound of a cell that was done
  CertifyResult result_;
};

}  // namespace rectilin::certification
