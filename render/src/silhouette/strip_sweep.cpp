#include "silhouette/strip_sweep.h"

#include <algorithm>
#include <cmath>

namespace rectilin::render {

double edge_x(const JumpEdge& edge, double y) {
  const double share = std::clamp((y - edge.low_y) / (edge.high_y - edge.low_y), 0.0, 1.0);
  return edge.low_x + share * (edge.high_x - edge.low_x);
}

void StripSweep::add(const Cell& cell, std::span<const JumpEdge> edges, std::span<const BorderStep> steps,
                     CoveredArea& sum) {
  heights_.assign({cell.low, cell.high});
  for (const JumpEdge& e : edges) heights_.insert(heights_.end(), {e.low_y, e.high_y});
  for (const BorderStep& s : steps) heights_.push_back(s.y);
  std::sort(heights_.begin(), heights_.end());
  heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());

  if (stack_.empty()) stack_.emplace_back();
  std::int32_t multiplicity = cell.multiplicity;
  std::size_t step = 0;
  for (std::size_t i = 0; i + 1 < heights_.size(); ++i) {
    const double low = heights_[i], high = heights_[i + 1];
    for (; step < steps.size() && steps[step].y <= low; ++step) multiplicity += steps[step].jump;
    std::vector<Run>& runs = stack_.front();
    runs.clear();
    for (const JumpEdge& e : edges)
      if (e.low_y <= low && high <= e.high_y) runs.push_back({edge_x(e, low), edge_x(e, high), e.jump});
    sum.slack += static_cast<double>(runs.size()) * rounding_ * (high - low);
    depth_ = 0;
    add_strip(cell, low, high, multiplicity, runs, sum);
  }
}

void StripSweep::add_strip(const Cell& cell, double low, double high, std::int32_t multiplicity, std::vector<Run>& runs,
                           CoveredArea& sum) {
  // In the order of the middle of the strip, and moved to keep it at both ends. Runs come nearly in order, but for the
  // first strip of many.
  const auto before = [](const Run& a, const Run& b) { return a.low_x + a.high_x < b.low_x + b.high_x; };
  if (runs.size() > 32 && !std::is_sorted(runs.begin(), runs.end(), before))
    std::sort(runs.begin(), runs.end(), before);
  for (std::size_t i = 1; i < runs.size(); ++i)
    for (std::size_t k = i; k > 0 && before(runs[k], runs[k - 1]); --k) std::swap(runs[k], runs[k - 1]);
  double low_end = cell.left, high_end = cell.left, low_length = 0, high_length = 0, moved = 0;
  std::int32_t m = multiplicity;
  for (const Run& run : runs) {
    const double low_x = std::max(low_end, run.low_x), high_x = std::max(high_end, run.high_x);
    moved += std::max(low_x - run.low_x, high_x - run.high_x);
    if (m > 0) low_length += low_x - low_end, high_length += high_x - high_end;
    m += run.jump;
    low_end = low_x, high_end = high_x;
  }
  if (m > 0) low_length += cell.right - low_end, high_length += cell.right - high_end;

  const double height = high - low;
  const auto accept = [&] {
    sum.area += height * (low_length + high_length) / 2;
    sum.slack += height * moved;
    ++strips_;
  };
  if (moved <= rounding_ * static_cast<double>(runs.size())) return accept();

  // The neighbours that are in the wrong order by most at one of the ends cross within the strip: cut it there.
  double worst = 0, cut = low;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const double at_low = runs[i + 1].low_x - runs[i].low_x, at_high = runs[i + 1].high_x - runs[i].high_x;
    if (-std::min(at_low, at_high) <= worst) continue;
    worst = -std::min(at_low, at_high);
    cut = low + height * (at_low / (at_low - at_high));
  }
  if (!(low < cut && cut < high)) return accept();  // a strip of a few units of rounding
  const double share = (cut - low) / height;
  sum.slack += static_cast<double>(runs.size()) * rounding_ * height;
  ++depth_;
  if (stack_.size() <= depth_) stack_.resize(depth_ + 1);
  const std::size_t own = depth_;
  std::vector<Run> upper = std::move(stack_[own]);
  upper.clear();
  for (Run& run : runs) {
    const double middle = run.low_x + share * (run.high_x - run.low_x);
    upper.push_back({middle, run.high_x, run.jump});
    run.high_x = middle;
  }
  add_strip(cell, low, cut, multiplicity, runs, sum);
  add_strip(cell, cut, high, multiplicity, upper, sum);
  stack_[own] = std::move(upper);
  --depth_;
}

}  // namespace rectilin::render
