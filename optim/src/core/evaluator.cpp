#include "rectilin/optim/evaluator.h"

#include <algorithm>

namespace rectilin {

Evaluator::Evaluator(const Objective& objective, Budget budget, std::stop_token stop)
    : objective_(objective), budget_(budget), stop_(std::move(stop)) {}

double Evaluator::value(const Rotation& rotation) {
  double value;
  values({&rotation, 1}, {&value, 1});
  return value;
}

Cut Evaluator::cut(const Rotation& rotation) {
  Cut cut;
  cuts({&rotation, 1}, {&cut, 1});
  return cut;
}

void Evaluator::values(std::span<const Rotation> rotations, std::span<double> values) {
  const std::size_t count = affordable(rotations.size(), Costs::kPerValue);
  if (count > 0) objective_.values(rotations.first(count), values.first(count));
  const std::uint64_t before = costs_.evaluations();
  for (std::size_t i = 0; i < count; ++i) account(rotations[i], values[i], before + (i + 1) * Costs::kPerValue);
  costs_.values += count;
  tell();
  std::ranges::fill(values.subspan(count), std::numeric_limits<double>::infinity());
}

void Evaluator::cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) {
  const std::size_t count = affordable(rotations.size(), Costs::kPerCut);
  if (count > 0) objective_.cuts(rotations.first(count), cuts.first(count));
  const std::uint64_t before = costs_.evaluations();
  for (std::size_t i = 0; i < count; ++i) account(rotations[i], cuts[i].value, before + (i + 1) * Costs::kPerCut);
  costs_.cuts += count;
  tell();
  std::ranges::fill(cuts.subspan(count), Cut{std::numeric_limits<double>::infinity(), Eigen::Matrix3d::Zero()});
}

SmoothValue Evaluator::smooth(const Rotation& rotation, double width) {
  if (affordable(1, Costs::kPerSmooth) == 0) return {std::numeric_limits<double>::infinity(), Eigen::Matrix3d::Zero()};
  ++costs_.smooths;
  const SmoothValue smooth = objective_.smooth(rotation, width);
  digest_.add(smooth.value);
  tell();
  return smooth;
}

double Evaluator::turn(Rotation& rotation, int k) {
  if (affordable(1, Costs::kPerTurn) == 0) return std::numeric_limits<double>::infinity();
  const BestTurn best = objective_.best_turn(rotation, k);
  rotation = best.rotation;
  ++costs_.turns;
  account(rotation, best.value, costs_.evaluations());
  tell();
  return best.value;
}

void Evaluator::raise_lower_bound(double bound) {
  if (lower_ && bound <= *lower_) return;
  lower_ = bound;
  record(costs_.evaluations());
  tell();
}

bool Evaluator::exhausted() const {
  return remaining() == 0 || stop_.stop_requested() || (budget_.limits_seconds() && seconds_left() <= 0);
}

std::uint64_t Evaluator::remaining() const {
  const std::uint64_t spent = costs_.evaluations();
  return budget_.evaluations > spent ? budget_.evaluations - spent : 0;
}

double Evaluator::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::size_t Evaluator::affordable(std::size_t count, std::uint64_t price) const {
  if (exhausted()) return 0;
  return static_cast<std::size_t>(std::min<std::uint64_t>(count, remaining() / price));
}

void Evaluator::tell() {
  if (!observer_ || seconds() < next_telling_) return;
  next_telling_ = seconds() + 0.1;
  observer_(*this);
}

void Evaluator::account(const Rotation& rotation, double value, std::uint64_t evaluations) {
  digest_.add(value);
  if (!(value < incumbent_.value)) return;
  incumbent_ = {rotation, value};
  record(evaluations);
}

void Evaluator::record(std::uint64_t evaluations) {
  trace_.push_back(
      {evaluations, seconds(), incumbent_.value, lower_.value_or(-std::numeric_limits<double>::infinity())});
}

}  // namespace rectilin
