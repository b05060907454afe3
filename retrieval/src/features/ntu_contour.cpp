#include "features/ntu_contour.h"

#include <algorithm>
#include <array>

namespace rectilin::retrieval {
namespace {

/// Rows from below, as the program has its pictures: which pixel is first depends on it.
Mask upside_down(const Mask& mask) {
  Mask result(mask.size);
  for (int y = 0; y < mask.size; ++y)
    std::copy_n(mask.pixels.begin() + static_cast<std::ptrdiff_t>(mask.at(0, y)), mask.size,
                result.pixels.begin() + static_cast<std::ptrdiff_t>(result.at(0, mask.size - 1 - y)));
  return result;
}

/// Pavlidis's walk: of the three pixels ahead the one on the right hand first; if none is covered, turn left.
std::vector<Pixel> walk_around(const Mask& mask) {
  constexpr std::array<Pixel, 4> kAhead{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};  // each left of the one before
  const auto first = std::ranges::find(mask.pixels, 1);
  if (first == mask.pixels.end()) return {};
  const auto at = static_cast<int>(first - mask.pixels.begin());
  const Pixel start{at % mask.stride() - 1, at / mask.stride() - 1};
  // The walk may come back to the start before it saw the part on the other side of it, coming in to the right.
  const auto below = [&](int dx) { return mask.covered(start.x + dx, start.y + 1); };
  const bool two_sides = below(-1) && !below(0) && (below(1) || mask.covered(start.x + 1, start.y));

  const std::size_t steps = 4 * static_cast<std::size_t>(std::ranges::count(mask.pixels, 1));
  std::vector<Pixel> contour{start};
  Pixel p = start;
  std::size_t facing = 0;
  while (contour.size() <= steps) {  // a pixel is left at most once in each direction
    bool walked = false;
    for (int turn = 0; turn < 4 && !walked; ++turn) {
      const Pixel ahead = kAhead[facing], right = kAhead[(facing + 3) % 4];
      for (int side = 1; side >= -1 && !walked; --side) {
        const Pixel next{p.x + ahead.x + side * right.x, p.y + ahead.y + side * right.y};
        if (!mask.covered(next.x, next.y)) continue;
        p = next;
        if (side == 1) facing = (facing + 3) % 4;
        walked = true;
      }
      if (!walked) facing = (facing + 1) % 4;
    }
    if (!walked) return {};  // a lone pixel
    contour.push_back(p);
    if (p.x == start.x && p.y == start.y && !(two_sides && facing == 1)) break;
  }
  return contour;
}

/// Whether the outline leaves more than a twentieth of the picture outside. Inside is what cannot be reached from the
/// picture's border by steps to the side without treading on the outline.
bool in_several_parts(const Mask& mask, const std::vector<Pixel>& outline) {
  std::vector<std::uint8_t> closed(mask.pixels.size());
  for (const Pixel& p : outline) closed[mask.at(p.x, p.y)] = 1;
  const int stride = mask.stride(), last = stride - 1;
  std::vector<int> stack{0};
  closed[0] = 2;
  std::size_t outside = 0;
  while (!stack.empty()) {
    const int at = stack.back(), x = at % stride, y = at / stride;
    stack.pop_back();
    outside += mask.pixels[static_cast<std::size_t>(at)];
    const auto visit = [&](int next) {
      if (closed[static_cast<std::size_t>(next)] != 0) return;
      closed[static_cast<std::size_t>(next)] = 2;
      stack.push_back(next);
    };
    if (x > 0) visit(at - 1);
    if (x < last) visit(at + 1);
    if (y > 0) visit(at - stride);
    if (y < last) visit(at + stride);
  }
  const auto all = static_cast<double>(std::ranges::count(mask.pixels, 1));
  return (all - static_cast<double>(outside)) / all <= 0.95;
}

/// Covers what lies within `reach` pixels each way of something covered, without a square's corners if it is 2. The
/// two outermost rows and columns stay as they are.
Mask grown_by(const Mask& mask, int reach) {
  Mask result = mask;
  for (int y = 2; y < mask.size - 2; ++y)
    for (int x = 2; x < mask.size - 2; ++x)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
          if (std::abs(dx) + std::abs(dy) < 4 && mask.covered(x + dx, y + dy)) result.pixels[result.at(x, y)] = 1;
  return result;
}

Mask bounding_box(const Mask& mask) {
  int left = mask.size, right = -1, top = mask.size, bottom = -1;
  for (int y = 0; y < mask.size; ++y)
    for (int x = 0; x < mask.size; ++x)
      if (mask.covered(x, y)) {
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
  Mask result(mask.size);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) result.pixels[result.at(x, y)] = 1;
  return result;
}

/// See thinned_to(). Going round the pixel, its covered neighbours hang together by their sides if at most one run of
/// them has one of the four next to it.
bool may_go(const Mask& mask, int x, int y) {
  constexpr std::array<Pixel, 8> kRound{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const auto covered = [&](std::size_t k) { return mask.covered(x + kRound[k % 8].x, y + kRound[k % 8].y); };
  int neighbours = 0, sides = 0, joints = 0;
  for (std::size_t k = 0; k < 8; ++k) neighbours += covered(k);
  for (std::size_t k = 0; k < 8; k += 2) {
    sides += covered(k);
    joints += covered(k) && covered(k + 1) && covered(k + 2);
  }
  return neighbours != 1 && (sides - joints <= 1);
}

}  // namespace

Mask thinned_to(Mask grown, const Mask& kept) {
  const int size = grown.size;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Pixel side : {Pixel{0, -1}, Pixel{0, 1}, Pixel{-1, 0}, Pixel{1, 0}}) {
      std::vector<std::size_t> gone;
      for (int y = 1; y < size - 1; ++y)
        for (int x = 1; x < size - 1; ++x)
          if (grown.covered(x, y) && !kept.covered(x, y) && !grown.covered(x + side.x, y + side.y) &&
              may_go(grown, x, y))
            gone.push_back(grown.at(x, y));
      for (const std::size_t at : gone) grown.pixels[at] = 0;
      changed = changed || !gone.empty();
    }
  }
  return grown;
}

std::vector<Pixel> ntu_contour(const Mask& silhouette) {
  const Mask mask = upside_down(silhouette);
  std::vector<Pixel> contour = walk_around(mask);
  if (std::ranges::count(mask.pixels, 1) > 0 && in_several_parts(mask, contour)) {
    Mask grown = mask;
    bool apart = true;
    for (const int reach : {1, 2}) {
      if (!apart) break;
      grown = grown_by(grown, reach);
      apart = in_several_parts(grown, walk_around(grown));
    }
    contour = walk_around(thinned_to(apart ? bounding_box(mask) : grown, mask));
  }
  if (contour.size() < 8) return {};
  for (Pixel& p : contour) p.y = mask.size - 1 - p.y;
  return contour;
}

}  // namespace rectilin::retrieval
