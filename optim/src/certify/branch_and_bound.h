// The branch and bound search: takes rounds of cells from the heap and puts their halves back.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "certify/bounder.h"
#include "certify/cell_heap.h"
#include "certify/kink_ball.h"
#include "certify/proof_tree.h"
#include "certify/sieve.h"
#include "certify/support_floor.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// The least value of the objective whose merit is within `gap` of the merit of `value`.
double cutoff_value(const Objective& objective, double value, double gap);

/// The largest such value; infinite if every larger value qualifies.
double threshold_value(const Objective& objective, double value, double gap);

/// The rounding error of a computed bound, in units of the objective: the true bound may be lower by this much.
double rounding_allowance(const CutBounds& bounds);

/// One run. A round takes the cells with the least bounds, takes the cuts that they need in one batch, works on the
/// cells in parallel, each with a slot of its own for results, and merges the slots in order. So the result does not
/// depend on the number of threads.
class BranchAndBound {
 public:
  /// `proof` may be null. The references must outlive the object.
  BranchAndBound(Evaluator& evaluator, const CertifyOptions& options, ProofTree* proof);

  CertifyResult run();

 private:
  /// What proves a cell's bound once it is high enough: these weights of its cuts or, if set, floors.
  struct Reason {
    PerCut<double> weight = {};
    std::optional<std::array<double, 3>> floors = {};
  };

  /// A half of a cell.
  struct Part {
    enum class State { kOpen, kDone, kOutside, kInBall };
    State state = State::kOpen;
    Cell cell;
    Reason reason;  // set if the part is done
  };

  /// A cell of the round, and what becomes of it.
  struct Slot {
    bool done = false;  // otherwise it was halved
    Cell cell;
    std::optional<std::uint32_t> cuts;  // index of the first of its three new cuts, if it asked for some
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
  /// Is the sieve in use? A proof is shorter with larger leaves, and where floors are needed cuts settle little.
  bool sifts() const { return !proof_ && !floors_; }
  void expand(Slot& slot) const;
  void halve(Slot& slot) const;
  bool may_settle(const Rest& rest) const;
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
  std::uint64_t cells_at_balls_ = 0;  // number of cells when balls were last made
  std::unique_ptr<SupportFloor> floors_;
  bool flatness_is_known_ = false;
  Random jitter_{1};

  double cutoff_ = std::numeric_limits<double>::infinity();  // a bound this high closes the gap
  double enough_ =
      std::numeric_limits<double>::infinity();  // cutoff plus allowance for rounding: cells with this bound are done
  double least_settled_ = std::numeric_limits<double>::infinity();  // least bound of a cell that was done
  CertifyResult result_;
};

}  // namespace rectilin::certification
