#include "features/contour.h"

#include <algorithm>
#include <numeric>

namespace rectilin::retrieval {
namespace {

/// Runs of covered pixels, joined into parts with union and find: much fewer than pixels.
struct Run {
  int y, first, last;
};

class Parts {
 public:
  explicit Parts(const Mask& mask) {
    std::size_t above = 0, above_end = 0;  // the runs of the row before
    for (int y = 0; y < mask.size; ++y) {
      const std::size_t begin = runs_.size();
      const std::uint8_t* row = mask.pixels.data() + mask.at(0, y);
      for (int x = 0; x < mask.size;) {
        if (row[x] == 0) {
          ++x;
          continue;
        }
        const int first = x;
        while (row[x] != 0) ++x;  // the border ends it
        add({y, first, x - 1}, above, above_end);
      }
      above = begin;
      above_end = runs_.size();
    }
  }

  /// First pixel in reading order of the largest part.
  Pixel start_of_largest() const {
    std::vector<long> area(runs_.size());
    for (std::size_t i = 0; i < runs_.size(); ++i) area[find(i)] += runs_[i].last - runs_[i].first + 1;
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(area) - area.begin());
    return {runs_[largest].first, runs_[largest].y};  // a part's root is its first run
  }

  bool empty() const { return runs_.empty(); }

 private:
  void add(const Run& run, std::size_t above, std::size_t above_end) {
    const std::size_t own = runs_.size();
    runs_.push_back(run);
    parent_.push_back(own);
    for (std::size_t i = above; i < above_end; ++i)
      if (runs_[i].first <= run.last + 1 && run.first <= runs_[i].last + 1) unite(i, own);
  }
  std::size_t find(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  std::vector<Run> runs_;
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<Pixel> trace_from(const Mask& mask, Pixel start) {
  // Neighbours clockwise on the screen (y down), from the left one.
  constexpr std::array<Pixel, 8> kAround{{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
  std::vector<Pixel> contour{start};
  const auto next_from = [&](Pixel p, int from) {  // the first covered neighbour, going round from `from`; -1 if none
    for (int k = 0; k < 8; ++k) {
      const int d = (from + k) % 8;
      if (mask.covered(p.x + kAround[static_cast<std::size_t>(d)].x, p.y + kAround[static_cast<std::size_t>(d)].y))
        return d;
    }
    return -1;
  };
  const int first = next_from(start, 0);  // left of the start and above it nothing is covered
  if (first < 0) return contour;
  Pixel p = start;
  int direction = first;
  for (;;) {
    const Pixel step = kAround[static_cast<std::size_t>(direction)];
    p = {p.x + step.x, p.y + step.y};
    // Go on from the neighbour after the last uncovered one that was looked at, seen from the new pixel.
    const int next = next_from(p, (direction % 2 == 0 ? direction + 7 : direction + 6) % 8);
    if (p.x == start.x && p.y == start.y && next == first) break;
    contour.push_back(p);
    direction = next;
  }
  return contour;
}

std::vector<Pixel> outer_contour(const Mask& mask) {
  const Parts parts(mask);
  return parts.empty() ? std::vector<Pixel>{} : trace_from(mask, parts.start_of_largest());
}

std::size_t boundary_pixels(const Mask& mask) {
  const int stride = mask.stride();
  std::size_t count = 0;
  for (int y = 0; y < mask.size; ++y) {
    const std::uint8_t* row = mask.pixels.data() + mask.at(0, y);
    for (int x = 0; x < mask.size; ++x) {
      const std::uint8_t* p = row + x;
      const int all =
          p[-stride - 1] & p[-stride] & p[-stride + 1] & p[-1] & p[1] & p[stride - 1] & p[stride] & p[stride + 1];
      count += static_cast<std::size_t>(p[0] & (all ^ 1));
    }
  }
  return count;
}

}  // namespace rectilin::retrieval
