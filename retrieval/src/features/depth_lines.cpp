#include "features/depth_lines.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rectilin::retrieval {
namespace {

constexpr int kLongest = 256;

/// The states of pixels `depth(0)` ... `depth(n - 1)`; 0 is background, and `level` the largest step of level surface.
template <class Depth>
void append_line(std::vector<LineState>& states, int n, int level, const Depth& depth) {
  int first = 0, last = n - 1;
  while (first < n && depth(first) == 0) ++first;
  while (last >= 0 && depth(last) == 0) --last;
  for (int i = 0; i < n; ++i) {
    if (depth(i) == 0) {
      states.push_back(i < first || i > last ? LineState::kOutside : LineState::kGap);
      continue;
    }
    const bool next = i + 1 < n && depth(i + 1) != 0, before = i > 0 && depth(i - 1) != 0;
    const int step = next ? depth(i + 1) - depth(i) : before ? depth(i) - depth(i - 1) : 0;
    states.push_back(step > level ? LineState::kNearer : step < -level ? LineState::kFarther : LineState::kLevel);
  }
}

constexpr std::array<std::array<int, 5>, 5> kChange{
    {{0, 1, 2, 2, 2}, {1, 0, 2, 2, 2}, {2, 2, 0, 1, 1}, {2, 2, 1, 0, 2}, {2, 2, 1, 2, 0}}};

}  // namespace

std::vector<LineState> depth_lines(const render::DepthImage& image) {
  const int n = image.size;
  // The range of depths is as deep as the picture is wide.
  const int level = 65535 / (4 * n);
  std::vector<LineState> states;
  states.reserve(static_cast<std::size_t>(2 * n * n));
  for (int y = 0; y < n; ++y) append_line(states, n, level, [&](int x) { return int{image.at(x, y)}; });
  for (int x = 0; x < n; ++x) append_line(states, n, level, [&](int y) { return int{image.at(x, y)}; });
  return states;
}

int line_distance(std::span<const LineState> a, std::span<const LineState> b, int gap, int band) {
  if (std::ranges::equal(a, b)) return 0;
  const int n = static_cast<int>(a.size());
  constexpr int kFar = 1 << 20;
  std::array<int, kLongest + 2> row;  // row[j + 1]: the first i states of a against the first j of b
  row.fill(kFar);
  for (int j = 0; j <= std::min(n, band); ++j) row[static_cast<std::size_t>(j) + 1] = j * gap;
  for (int i = 1; i <= n; ++i) {
    const int from = std::max(0, i - band), to = std::min(n, i + band);
    const auto& change = kChange[static_cast<std::size_t>(a[static_cast<std::size_t>(i) - 1])];
    int diagonal = row[static_cast<std::size_t>(from)];  // of the row before, one place to the left
    row[static_cast<std::size_t>(from)] = kFar;
    for (int j = from; j <= to; ++j) {
      int& here = row[static_cast<std::size_t>(j) + 1];
      int least = std::min(here, row[static_cast<std::size_t>(j)]) + gap;
      if (j > 0)
        least = std::min(least, diagonal + change[static_cast<std::size_t>(b[static_cast<std::size_t>(j) - 1])]);
      diagonal = here;
      here = least;
    }
  }
  return row[static_cast<std::size_t>(n) + 1];
}

}  // namespace rectilin::retrieval
