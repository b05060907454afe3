#include "silhouette/multiplicity.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "silhouette/strip_sweep.h"

namespace rectilin::render {
namespace {

constexpr std::size_t kFew = 6;  // edges of a cell that is integrated rather than halved
constexpr int kMostZooms = 120;  // of either side in turn: then cells are as small as rounding

/// A cell with its share of the level's edges and steps.
struct Content {
  Cell cell;
  int zooms;    ///< halvings in a row that left most of the edges together
  int doubled;  ///< halvings since the whole picture that left most of them in one half and many in the other as well
  std::size_t first_edge, end_edge, first_step, end_step;

  std::size_t edges() const { return end_edge - first_edge; }
};

struct Level {
  std::vector<Content> cells;
  std::vector<JumpEdge> edges;
  std::vector<BorderStep> steps;

  void clear() { cells.clear(), edges.clear(), steps.clear(); }
  void begin(const Cell& cell) { cells.push_back({cell, 0, 0, edges.size(), 0, steps.size(), 0}); }
  void end() { cells.back().end_edge = edges.size(), cells.back().end_step = steps.size(); }
  std::span<const JumpEdge> edges_of(const Content& c) const {
    return std::span(edges).subspan(c.first_edge, c.end_edge - c.first_edge);
  }
  std::span<const BorderStep> steps_of(const Content& c) const {
    return std::span(steps).subspan(c.first_step, c.end_step - c.first_step);
  }
};

/// Edges on one line are doubled by every halving across them and never parted; so only some doublings are allowed on
/// the way to a cell, more of them the more edges there are and the dearer they are to integrate. Halvings that zoom in
/// on a part of the cell with most of its edges are cheap, and needed for parts far apart; where edges meet in one
/// point they would never end. All other halvings leave at most three quarters of the edges in either half.
bool worth_halving(const Content& content) {
  const std::size_t edges = content.edges();
  return edges > kFew && content.doubled < 2 + static_cast<int>(std::bit_width(edges)) &&
         content.zooms < static_cast<int>(std::min<std::size_t>(kMostZooms, 4 + edges / 4));
}

double area_of(const Cell& cell) { return (cell.right - cell.left) * (cell.high - cell.low); }

enum class Verdict { kCovered, kEmpty, kOpen };

/// What the least and the greatest multiplicity anywhere in the cell can be.
Verdict judge(const Cell& cell, std::span<const JumpEdge> edges, std::span<const BorderStep> steps) {
  std::int32_t border = cell.multiplicity, least = border, greatest = border;
  for (const BorderStep& s : steps) {
    border += s.jump;
    least = std::min(least, border), greatest = std::max(greatest, border);
  }
  for (const JumpEdge& e : edges) (e.jump < 0 ? least : greatest) += e.jump;
  return least > 0 ? Verdict::kCovered : greatest <= 0 ? Verdict::kEmpty : Verdict::kOpen;
}

class Halving {
 public:
  Halving(double scale, CoveredArea& sum) : rounding_(kEdgeRounding * scale), sum_(sum) {}

  void halve(const Content& content, const Level& from, Level& to) {
    const Cell& cell = content.cell;
    if (cell.high - cell.low >= cell.right - cell.left) halve_height(content, from, to);
    else halve_width(content, from, to);
    Content &one = to.cells[to.cells.size() - 2], &other = to.cells.back();
    const std::size_t fewer = std::min(one.edges(), other.edges()), more = std::max(one.edges(), other.edges());
    const bool together = 4 * more > 3 * content.edges();
    one.zooms = other.zooms = together ? content.zooms + 1 : 0;
    one.doubled = other.doubled = content.doubled + (together && 2 * fewer > content.edges() ? 1 : 0);
  }

 private:
  void halve_height(const Content& content, const Level& from, Level& to) {
    Cell lower = content.cell, upper = content.cell;
    const double y = lower.low + (lower.high - lower.low) / 2;
    lower.high = upper.low = y;
    to.begin(lower);
    for (const JumpEdge& e : from.edges_of(content)) {
      if (e.high_y <= y) to.edges.push_back(e);
      else if (e.low_y < y) to.edges.push_back({e.low_x, e.low_y, edge_x(e, y), y, e.jump});
    }
    for (const BorderStep& s : from.steps_of(content)) {
      if (s.y < y) to.steps.push_back(s);
      if (s.y <= y) upper.multiplicity += s.jump;
    }
    to.end();
    to.begin(upper);
    for (const JumpEdge& e : from.edges_of(content)) {
      if (e.low_y >= y) to.edges.push_back(e);
      else if (e.high_y > y) {
        to.edges.push_back({edge_x(e, y), y, e.high_x, e.high_y, e.jump});
        sum_.slack += rounding_ * (e.high_y - e.low_y);
      }
    }
    for (const BorderStep& s : from.steps_of(content))
      if (s.y > y) to.steps.push_back(s);
    to.end();
  }

  void halve_width(const Content& content, const Level& from, Level& to) {
    Cell near = content.cell, far = content.cell;
    const double x = near.left + (near.right - near.left) / 2;
    near.right = far.left = x;
    const auto steps = from.steps_of(content);
    passing_.assign(steps.begin(), steps.end());
    beyond_.clear();
    const auto passes =
        [&](const JumpEdge& part) {  // on the near side: a step up and one down on the far cell's border
          to.edges.push_back(part);
          passing_.push_back({part.low_y, part.jump});
          passing_.push_back({part.high_y, -part.jump});
        };
    to.begin(near);
    for (const JumpEdge& e : from.edges_of(content)) {
      if (std::max(e.low_x, e.high_x) <= x) passes(e);
      else if (std::min(e.low_x, e.high_x) >= x) beyond_.push_back(e);
      else {
        // The edge is bent a little so that it crosses at a height that there is.
        const double share = (x - e.low_x) / (e.high_x - e.low_x);
        const double y = std::clamp(e.low_y + share * (e.high_y - e.low_y), e.low_y, e.high_y);
        sum_.slack += (std::abs(edge_x(e, y) - x) + rounding_) * (e.high_y - e.low_y);
        const JumpEdge below{e.low_x, e.low_y, x, y, e.jump}, above{x, y, e.high_x, e.high_y, e.jump};
        const bool rising = e.low_x < e.high_x;
        const JumpEdge &here = rising ? below : above, &there = rising ? above : below;
        if (here.low_y < here.high_y) passes(here);
        if (there.low_y < there.high_y) beyond_.push_back(there);
      }
    }
    to.steps.insert(to.steps.end(), steps.begin(), steps.end());
    to.end();

    std::sort(passing_.begin(), passing_.end(), [](const BorderStep& a, const BorderStep& b) { return a.y < b.y; });
    std::size_t i = 0;
    for (; i < passing_.size() && passing_[i].y <= far.low; ++i) far.multiplicity += passing_[i].jump;
    to.begin(far);
    while (i < passing_.size()) {  // steps at one height are one, or none: chains of edges leave only their ends
      BorderStep step = passing_[i];
      for (++i; i < passing_.size() && passing_[i].y == step.y; ++i) step.jump += passing_[i].jump;
      if (step.jump != 0 && step.y < far.high) to.steps.push_back(step);
    }
    to.edges.insert(to.edges.end(), beyond_.begin(), beyond_.end());
    to.end();
  }

  double rounding_;
  CoveredArea& sum_;
  std::vector<BorderStep> passing_;
  std::vector<JumpEdge> beyond_;
};

}  // namespace

CoveredArea covered_area(std::vector<JumpEdge> edges, double tolerance) {
  CoveredArea sum;
  if (edges.empty()) return sum;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Cell all{kInfinity, -kInfinity, kInfinity, -kInfinity, 0};
  for (const JumpEdge& e : edges) {
    all.left = std::min({all.left, e.low_x, e.high_x}), all.right = std::max({all.right, e.low_x, e.high_x});
    all.low = std::min(all.low, e.low_y), all.high = std::max(all.high, e.high_y);
  }
  const double scale = std::max({std::abs(all.left), std::abs(all.right), std::abs(all.low), std::abs(all.high)});
  StripSweep sweep(scale);
  Halving halving(scale, sum);

  Level level, next;
  level.edges = std::move(edges);
  level.cells.push_back({all, 0, 0, 0, level.edges.size(), 0, 0});
  double open = area_of(all);
  std::size_t settled = 0;
  // Memory is bounded: a level beyond that is integrated, however long it takes.
  const std::size_t most = 16 * level.edges.size() + (std::size_t{1} << 22);
  const auto enough = [&] { return open <= tolerance * sum.area; };
  while (!level.cells.empty() && !enough()) {
    next.clear();
    std::size_t i = 0;
    for (; i < level.cells.size() && !enough(); ++i) {
      const Content& content = level.cells[i];
      const auto inside = level.edges_of(content);
      const auto steps = level.steps_of(content);
      const Verdict verdict = judge(content.cell, inside, steps);
      if (verdict == Verdict::kOpen && worth_halving(content) && next.edges.size() < most) {
        halving.halve(content, level, next);
        continue;
      }
      if (verdict == Verdict::kCovered) sum.area += area_of(content.cell);
      if (verdict == Verdict::kOpen) sweep.add(content.cell, inside, steps, sum);
      open -= area_of(content.cell);
      ++settled;
    }
    // Added up afresh: what was subtracted from the whole is not sharp where the picture is nearly empty.
    open = 0;
    for (const Content& content : next.cells) open += area_of(content.cell);
    for (; i < level.cells.size(); ++i) open += area_of(level.cells[i].cell), ++settled;
    settled += next.cells.size();
    sum.open = open;
    if (enough()) break;
    std::swap(level, next);
  }
  // Sums of so many positive terms, each rounded.
  const auto terms = static_cast<double>(settled + sweep.strips() + 64);
  sum.slack = 1.001 * sum.slack + 0x1p-51 * terms * (sum.area + sum.open);
  return sum;
}

}  // namespace rectilin::render
