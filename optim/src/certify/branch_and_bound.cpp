#include "certify/branch_and_bound.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "certify/box_bound.h"
#include "certify/descent.h"

namespace rectilin::certification {
namespace {

/// How far the rotations at which cuts are taken are moved off the minima of the model, in each Rodrigues component, at
/// most and in units of the gap. At such a minimum faces tend to be parallel to axes to the last bit, so the signs in
/// the cut would be rounding noise. A little off they are the same for everyone who computes the cut again.
constexpr double kJitter = 1e-8, kLeastJitter = 1e-15, kJitterPerGap = 0.01;

constexpr std::size_t kOpenPerRound = 16, kGrowth = 16;  // a round takes 1/16 of the open cells, but at most 16 batches
/// The first radius of a descent from a rotation that is better than what an earlier descent found: most of these lie
/// near their minimum.
constexpr double kNarrowSearch = 0.01;

/// Mixtures are found where the cuts exceed what is enough by this part of what the bound lacks.
constexpr double kLeastExcess = 0.1;

constexpr std::uint64_t kCellsBeforeBalls = 1000;
constexpr std::uint64_t kGeneratorsPerCell = 100;  // a ball looks at this many generators in at most the time of a cell

constexpr std::uint64_t kCellsBeforeFloors = 2000;  // by then the incumbent shows how flat the landscape is
constexpr double kProofMargin = 4e-12;  // floors in proofs are lowered by this: a checker sums in another order
constexpr double kProofWider = 0.01;    // and sweeps widened by this: a checker may find them a little larger
// Floors cost as much as this many cells, fixed and for each generator.
constexpr double kManyCells = 8e4, kCellsPerGenerator = 8;

/// Two neighbouring numbers between which the merit, which falls as the value grows, passes `target`.
struct Passage {
  double low, high;

  Passage(const Objective& objective, double target, double above, double below) : low(above), high(below) {
    for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
      (objective.merit(middle) <= target ? high : low) = middle;
  }
};

/// Gives a cell what a sieve has left of it. The longest edge will be halved: how much each would gain is known from
/// mixtures only.
void narrow(Cell& cell, const Rest& rest) {
  cell.box = rest.box;
  cell.bound = std::max(cell.bound, rest.bound);
  cell.low_point = rest.low_point;
  cell.model = rest.value;
  cell.spread = rest.box.half_edges().cast<float>();
}

}  // namespace

double cutoff_value(const Objective& objective, double value, double gap) {
  return Passage(objective, objective.merit(value) + gap, 0, value).high;
}

double threshold_value(const Objective& objective, double value, double gap) {
  const double target = objective.merit(value) - gap;
  double beyond = 2 * value;
  while (std::isfinite(beyond) && objective.merit(beyond) > target) beyond *= 2;
  return std::isfinite(beyond) ? Passage(objective, target, value, beyond).low : beyond;
}

double rounding_allowance(const CutBounds& bounds) { return 3 * bounds.error + kBoxRounding * bounds.norm; }

BranchAndBound::BranchAndBound(Evaluator& evaluator, const CertifyOptions& options, ProofTree* proof)
    : evaluator_(evaluator),
      options_(options),
      proof_(proof),
      generators_(evaluator.objective().generators()),
      facts_(evaluator.objective().cut_bounds()),
      allowance_(rounding_allowance(facts_)),
      bounder_(table_, options.bundle) {}

CertifyResult BranchAndBound::run() {
  Cell zone;
  zone.box = Box::zone();
  zone.bound = facts_.floor + allowance_;
  heap_.push(zone);
  update_cutoff();
  report();
  while (!heap_.empty() && facts_.floor < cutoff_ && !stopped()) {
    take_round();
    if (!evaluate_round()) {
      for (const Slot& slot : round_) heap_.push(slot.cell);
      break;
    }
    update_balls();
    update_floors();
    if (floors_) floors_->update();
    tbb::parallel_for(std::size_t{0}, round_.size(), [this](std::size_t i) { expand(round_[i]); });
    for (Slot& slot : round_) merge(slot);
    report();
  }
  report();
  result_.incumbent = evaluator_.incumbent();
  result_.closed = evaluator_.has_incumbent() && (heap_.empty() || facts_.floor >= cutoff_);
  if (floors_) result_.floor_triangles = floors_->triangles();
  if (proof_) settle_open_cells();
  return std::move(result_);
}

bool BranchAndBound::stopped() const {
  return evaluator_.exhausted() ||
         (options_.cells > 0 && result_.cells >= static_cast<std::uint64_t>(options_.cells)) ||
         (options_.seconds > 0 && evaluator_.seconds() >= options_.seconds);
}

void BranchAndBound::take_round() {
  // When many cells are open, it matters less which of them come first than that all threads have work.
  const std::size_t batch = static_cast<std::size_t>(options_.batch);
  const std::size_t most = std::clamp(heap_.size() / kOpenPerRound, batch, kGrowth * batch);
  round_.clear();
  while (!heap_.empty() && round_.size() < most) {
    Cell cell = heap_.pop();
    if (cell.bound >= enough_) {
      if (!proof_) {
        settle(cell, {});
        continue;
      }
      cell.bound = facts_.floor;  // the bound may come from a larger cell; the proof needs weights for this one
      const Reason reason = raise(cell);
      if (cell.bound >= enough_) {
        settle(cell, reason);
        continue;
      }
    }
    if (balls_.hold(cell.box)) ++result_.leaves;
    else round_.emplace_back().cell = cell;
  }
}

/// Takes new cuts at the minima of the models of those cells whose model is too low there: only a new cut can help
/// them. Returns false if the budget ends first.
bool BranchAndBound::evaluate_round() {
  const double before = evaluator_.incumbent().value;
  const double jitter = std::clamp(kJitterPerGap * options_.gap, kLeastJitter, kJitter);
  std::vector<Rotation> rotations;
  for (Slot& slot : round_) {
    if (slot.cell.model >= enough_) continue;
    slot.cuts = static_cast<std::uint32_t>(table_.size() + 3 * rotations.size());
    Eigen::Vector3d aside;
    for (double& component : aside) component = jitter_.uniform(-jitter, jitter);
    rotations.push_back(rotation_from_rodrigues(slot.cell.low_point + aside));
  }
  if (rotations.empty()) return true;
  std::vector<Cut> cuts(rotations.size());
  evaluator_.cuts(rotations, cuts);
  if (cuts.back().value == std::numeric_limits<double>::infinity()) return false;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    table_.add(rotations[i], cuts[i]);
    if (proof_) proof_->add_cuts(rotations[i]);
  }
  improve_incumbent(rotations, cuts, before);
  return true;
}

void BranchAndBound::improve_incumbent(std::span<const Rotation> rotations, std::span<const Cut> cuts, double before) {
  const auto best = std::ranges::min_element(cuts, {}, &Cut::value);
  if (!(best->value < before)) return;
  const double slack = std::isfinite(before) ? before - cutoff_ : 0;
  descend(evaluator_, rotations[static_cast<std::size_t>(best - cuts.begin())], *best, options_.descent,
          std::isfinite(before) ? kNarrowSearch : kWideSearch, 1e-6 * slack);
  update_cutoff();
}

void BranchAndBound::update_cutoff() {
  if (!evaluator_.has_incumbent()) return;
  // The goal is measured from the incumbent's value without its possible rounding error, so that the interval is narrow
  // enough once it is stated with all rounding. But no bound computed at the incumbent can exceed its value less
  // rounding: asking for more would never end.
  const double value = evaluator_.incumbent().value;
  cutoff_ =
      std::min(cutoff_value(evaluator_.objective(), value + 3 * facts_.error, options_.gap), value - 3 * allowance_);
  enough_ = cutoff_ + allowance_;
  balls_are_current_ = false;
}

void BranchAndBound::update_balls() {
  if (balls_are_current_ || !options_.balls || proof_ || generators_.size() == 0) return;
  // Balls may only take a part of the time. The earlier ones remain valid.
  if (result_.cells - cells_at_balls_ < std::max(kCellsBeforeBalls, generators_.size() / kGeneratorsPerCell)) return;
  balls_are_current_ = true;
  cells_at_balls_ = result_.cells;
  balls_.clear();
  result_.ball_angle = kink_ball(generators_, evaluator_.incumbent().rotation, enough_);
  if (result_.ball_angle > 1e-6) balls_.add(evaluator_.incumbent().rotation, result_.ball_angle);
  least_settled_ = std::min(least_settled_, enough_);
}

/// Bounds of h on the sphere pay off where the whole landscape is flat. The mean of the objective over all rotations is
/// 3/2 of the sum of the generators' lengths (the paper's eq. 24). If the best value is a fraction d below that (or if
/// the gap is d, whichever is larger), about 2.7 d^(-3/2) cells are needed: that many small balls, in each of which the
/// curvature of a cell costs d, fill the zone. Measured on meshes with d from 0.00005 to 0.03.
bool BranchAndBound::is_flat() const {
  double mean = 0;
  for (std::size_t i = 0; i < generators_.size(); ++i) mean += 1.5 * generators_[i].norm();
  const double value = evaluator_.incumbent().value;
  const double depth = std::max(mean - value, value - cutoff_) / mean;
  const double cells = 2.7 * std::pow(depth, -1.5);
  return cells > std::max(kManyCells, kCellsPerGenerator * static_cast<double>(generators_.size()));
}

void BranchAndBound::update_floors() {
  if (flatness_is_known_ || !options_.floors || generators_.size() == 0 || result_.cells < kCellsBeforeFloors) return;
  flatness_is_known_ = true;
  if (!is_flat()) return;
  floors_ = std::make_unique<SupportFloor>(generators_, proof_ ? kProofMargin : 0, [this] { return stopped(); });
  if (proof_) proof_->set_form(floors_->form());
}

void BranchAndBound::expand(Slot& slot) const {
  // There is a better incumbent since the cell was taken. As in take_round(), the proof needs weights for this cell.
  if (proof_ && slot.cell.bound >= enough_) slot.cell.bound = facts_.floor;
  if (slot.cuts) {
    for (std::uint32_t k = 0; k < 3; ++k) slot.cell.bundles[k].add(*slot.cuts + k, options_.bundle);
    if (!sifts()) {  // with the sieve new cuts do more for the parts; of whole cells they settle one in eight
      slot.reason.weight = bounder_.raise(slot.cell, enough_);
      slot.done = slot.cell.bound >= enough_;
    }
  }
  if (!slot.done) halve(slot);
}

void BranchAndBound::halve(Slot& slot) const {
  const Cell& cell = slot.cell;
  for (int i = 1; i < 3; ++i)  // near ties go to the first axis, whatever the rounding
    if (cell.spread[i] > 1.0001f * cell.spread[slot.axis]) slot.axis = i;
  Halves left;
  if (sifts()) left = sift(cell, slot.axis, table_, balls_, enough_);
  for (std::size_t side = 0; side < 2; ++side) {
    Part& part = slot.parts[side];
    part.cell = cell;
    if (!sifts()) part.cell.box = cell.box.half(slot.axis, static_cast<int>(side));
    else if (left[side]) narrow(part.cell, *left[side]);
    else part.cell.bound = enough_;
    if (part.cell.bound >= enough_) {
      part.state = Part::State::kDone;
    } else if (!part.cell.box.meets_zone()) {
      part.state = Part::State::kOutside;
    } else if (balls_.hold(part.cell.box)) {
      part.state = Part::State::kInBall;
    } else if (!sifts() || may_settle(*left[side])) {
      part.reason = raise(part.cell);
      if (part.cell.bound >= enough_) part.state = Part::State::kDone;
    }
  }
}

/// No mixture of the known cuts exceeds the sieve's value at the low point, and few come near it everywhere on the box.
bool BranchAndBound::may_settle(const Rest& rest) const {
  return rest.value - enough_ >= kLeastExcess * (enough_ - rest.bound);
}

BranchAndBound::Reason BranchAndBound::raise(Cell& cell) const {
  Reason reason = {.weight = bounder_.raise(cell, enough_)};
  if (!floors_ || cell.bound >= enough_) return reason;
  const Corners corners(cell.box);
  const Rotation middle = rotation_from_rodrigues(cell.box.centre());
  const auto sweep = [&](int axis) { return Sweep(cell.box, corners, middle, axis, proof_ ? kProofWider : 0); };
  reason.floors = floors_->prove({sweep(0), sweep(1), sweep(2)}, enough_);
  if (reason.floors) cell.bound = enough_;
  return reason;
}

void BranchAndBound::merge(Slot& slot) {
  if (slot.done) return settle(slot.cell, slot.reason);
  if (sifts()) least_settled_ = std::min(least_settled_, enough_);  // what the sieve left out is no lower than that
  const std::uint32_t node = proof_ ? proof_->halve(slot.cell.node, slot.axis) : 0;
  for (std::uint32_t side = 0; side < 2; ++side) {
    Part& part = slot.parts[side];
    part.cell.node = node + side;
    if (part.state == Part::State::kOutside) {
      if (proof_) proof_->set_outside(part.cell.node);
      continue;
    }
    ++result_.cells;
    if (part.state == Part::State::kOpen) heap_.push(part.cell);
    else if (part.state == Part::State::kDone) settle(part.cell, part.reason);
    else ++result_.leaves;
  }
}

void BranchAndBound::settle(Cell& cell, const Reason& reason) {
  ++result_.leaves;
  least_settled_ = std::min(least_settled_, cell.bound);
  if (!proof_) return;
  if (reason.floors) proof_->set_floor_leaf(cell.node, *reason.floors);
  else proof_->set_leaf(cell.node, cell.bundles, reason.weight);
}

/// Makes the cells that a stopped run leaves open leaves as well, of a proof of a lower bound.
void BranchAndBound::settle_open_cells() {
  double least = least_settled_;
  while (!heap_.empty()) {
    const Cell cell = heap_.pop();
    if (cell.bundles[0].size == 0) return;                     // the run was stopped before the first cuts
    const Bounder::Bound bound = bounder_.mix(cell, enough_);  // what these cuts prove on this cell, nothing inherited
    proof_->set_leaf(cell.node, cell.bundles, bound.weight);
    least = std::min(least, bound.value);
  }
  proof_->set_bound(least - allowance_);
}

/// Tells the evaluator the bound proved so far.
void BranchAndBound::report() {
  evaluator_.note_parts_bounded(result_.cells);
  const double value = evaluator_.incumbent().value;
  const double proved = std::min({heap_.least_bound(), least_settled_}) - allowance_;
  const double lower = std::min(std::max(proved, facts_.floor), value);
  const bool news = result_.trajectory.empty() || lower > result_.lower || value < result_.trajectory.back().value;
  result_.lower = std::max(result_.lower, lower);
  if (!news) return;
  evaluator_.raise_lower_bound(result_.lower);
  result_.trajectory.push_back(
      {result_.cells, evaluator_.costs().evaluations(), evaluator_.seconds(), value, result_.lower});
}

}  // namespace rectilin::certification
