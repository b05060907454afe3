// The one door through which an optimizer evaluates anything.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "rectilin/base/fnv1a.h"
#include "rectilin/optim/objective.h"

namespace rectilin {

/// What a run may spend. A budget in evaluations gives the same result every time; with one in seconds the clock
/// decides where the same run ends.
struct Budget {
  std::uint64_t evaluations = std::numeric_limits<std::uint64_t>::max();
  double seconds = std::numeric_limits<double>::infinity();

  bool limits_evaluations() const { return evaluations < std::numeric_limits<std::uint64_t>::max(); }
  bool limits_seconds() const { return seconds < std::numeric_limits<double>::infinity(); }
};

/// Costs in the one declared unit, an evaluation: the value of the objective at one rotation. What else can be asked
/// for has a fixed price, so that budgets and traces do not depend on the machine: its time in values, measured on
/// meshes of 300 to 20,000 faces (papers/laboratory.md). On larger meshes
/// values are summed by a tree, which smooth values and turns are not: there these cost several times their price.
struct Costs {
  static constexpr std::uint64_t kPerValue = 1;
  static constexpr std::uint64_t kPerCut = 2;     ///< sums three components a face where a value sums one
  static constexpr std::uint64_t kPerSmooth = 5;  ///< square roots and divisions
  static constexpr std::uint64_t kPerTurn = 20;   ///< angles of all faces, partly sorted

  std::uint64_t values = 0;   ///< rotations whose value was asked for
  std::uint64_t cuts = 0;     ///< rotations whose cut was asked for
  std::uint64_t smooths = 0;  ///< rotations at which the smooth surrogate was asked for
  std::uint64_t turns = 0;    ///< circles that were minimised over

  std::uint64_t evaluations() const {
    return kPerValue * values + kPerCut * cuts + kPerSmooth * smooths + kPerTurn * turns;
  }
};

/// The best rotation seen in a run.
struct Incumbent {
  Rotation rotation;
  double value = std::numeric_limits<double>::infinity();
};

/// A step of a run's history: after `evaluations`, the best value was `value` and the minimum was known
/// to be at least `lower`.
struct TracePoint {
  std::uint64_t evaluations;
  double seconds;  ///< since the run began; the only field that differs between two equal runs
  double value;
  double lower;
};

/// Owns the budget, the count, the incumbent and the trace of one run, so that they hold whatever the
/// optimizer (or a foreign library inside it) does. Past the budget nothing is evaluated or counted:
/// values come back infinite. Not thread safe: a run asks from one thread, in batches, which the objective
/// works on with all threads.
class Evaluator {
 public:
  /// `objective` must outlive the evaluator.
  explicit Evaluator(const Objective& objective, Budget budget = {}, std::stop_token stop = {});

  const Objective& objective() const { return objective_; }

  /// Has `observer` told now and then (between evaluations, ten times a second at most) how the run is getting on. It
  /// sees the run and cannot change it.
  void watch(std::function<void(const Evaluator&)> observer) { observer_ = std::move(observer); }

  double value(const Rotation& rotation);
  void values(std::span<const Rotation> rotations, std::span<double> values);

  /// Value and subgradient. Past the budget the value is infinite and the gradient zero.
  Cut cut(const Rotation& rotation);
  void cuts(std::span<const Rotation> rotations, std::span<Cut> cuts);

  /// The smooth surrogate. It is an upper bound of the objective, so its value counts for the incumbent only
  /// once the objective itself is asked for. Past the budget the value is infinite and the gradient zero.
  SmoothValue smooth(const Rotation& rotation, double width);

  /// Moves `rotation` to the best of its turns about its axis k and returns the value there; past the budget
  /// it stays, and the value is infinite.
  double turn(Rotation& rotation, int k);

  /// Reports a proof that no rotation has a value below `bound`.
  void raise_lower_bound(double bound);

  /// Says, for whoever watches, how many parts of the domain the proof has bounded so far.
  void note_parts_bounded(std::uint64_t parts) {
    parts_bounded_ = parts;
    tell();
  }

  /// Is the budget spent, the time over or a stop asked for? Then an optimizer returns.
  bool exhausted() const;
  const Budget& budget() const { return budget_; }
  /// Evaluations left.
  std::uint64_t remaining() const;
  /// Since the run began.
  double seconds() const;
  double seconds_left() const { return budget_.seconds - seconds(); }

  bool has_incumbent() const { return incumbent_.value < std::numeric_limits<double>::infinity(); }
  const Incumbent& incumbent() const { return incumbent_; }
  const std::optional<double>& lower_bound() const { return lower_; }
  const Costs& costs() const { return costs_; }
  std::uint64_t parts_bounded() const { return parts_bounded_; }

  /// One point for every improvement of the incumbent or of the bound, and one for the first evaluation.
  const std::vector<TracePoint>& trace() const { return trace_; }

  /// A digest of every value given (of values, cuts, turns and the smooth surrogate), in the order asked for.
  std::uint64_t digest() const { return digest_.value(); }

 private:
  std::size_t affordable(std::size_t count, std::uint64_t price) const;
  void tell();
  void account(const Rotation& rotation, double value, std::uint64_t evaluations);
  void record(std::uint64_t evaluations);

  const Objective& objective_;
  Budget budget_;
  std::stop_token stop_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Costs costs_;
  std::uint64_t parts_bounded_ = 0;
  Incumbent incumbent_;
  std::optional<double> lower_;
  std::vector<TracePoint> trace_;
  Fnv1a digest_;
  std::function<void(const Evaluator&)> observer_;
  double next_telling_ = 0.5;  // seconds: short runs are not worth a word
};

}  // namespace rectilin
