#include "features/rich_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "features/contour.h"

namespace rectilin::retrieval {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

/// Adds to a histogram that goes round, to the two nearest bins by nearness; bin k is about angle k / count of a turn.
void add_round(std::span<float> bins, double turn, double weight) {
  const double n = static_cast<double>(bins.size());
  const double at = turn * n;
  const double floor = std::floor(at);
  const double part = at - floor;
  const auto k = static_cast<std::size_t>(static_cast<long>(floor) % static_cast<long>(bins.size()));
  bins[k] += static_cast<float>(weight * (1 - part));
  bins[(k + 1) % bins.size()] += static_cast<float>(weight * part);
}

/// The same for one with ends, the middle of bin k at (k + 1/2) / count.
void add_between(std::span<float> bins, double share, double weight) {
  const double n = static_cast<double>(bins.size());
  const double at = std::clamp(share * n - 0.5, 0.0, n - 1);
  const auto k = std::min(bins.size() - 2, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(k);
  bins[k] += static_cast<float>(weight * (1 - part));
  bins[k + 1] += static_cast<float>(weight * part);
}

void divide(std::span<float> bins, double by) {
  if (by > 0)
    for (float& x : bins) x = static_cast<float>(static_cast<double>(x) / by);
}

/// An angle modulo a right one, as a share of it in [0, 1).
double modulo_right_angle(double angle) {
  const double turn = angle / kRightAngle;
  return std::min(turn - std::floor(turn), 1 - 1e-12);
}

std::span<float> block(RichNumbers& numbers, std::size_t k) {
  return std::span(numbers).subspan(static_cast<std::size_t>(kRichBlocks[k].begin),
                                    static_cast<std::size_t>(kRichBlocks[k].count));
}

enum : std::size_t { kSlope = 3, kAspect, kContour, kBend, kDepth, kEdges, kExtent };

/// Slopes, directions of descent, depths and steps, from pixels and their neighbours.
void add_surface(const render::DepthImage& image, RichNumbers& numbers) {
  const int size = image.size;
  const double unit = 2.0 / 65535 / (2.0 / size);  // depth steps over a pixel, as a slope
  constexpr double kStep = 6;                      // a steeper slope is a step from one surface to another
  double surface = 0, covered = 0, least_x = size, most_x = -1, least_y = size, most_y = -1, steps = 0;
  double sum_x = 0, sum_y = 0;
  const auto aspect = block(numbers, kAspect), edges = block(numbers, kEdges);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int z = image.at(x, y);
      if (z == 0) continue;
      ++covered;
      sum_x += x;
      sum_y += y;
      least_x = std::min<double>(least_x, x);
      most_x = std::max<double>(most_x, x);
      least_y = std::min<double>(least_y, y);
      most_y = std::max<double>(most_y, y);
      add_between(block(numbers, kDepth), z / 65535.0, 1);
      if (x == 0 || y == 0 || x == size - 1 || y == size - 1) continue;
      const int left = image.at(x - 1, y), right = image.at(x + 1, y), up = image.at(x, y - 1),
                down = image.at(x, y + 1);
      if (left == 0 || right == 0 || up == 0 || down == 0) continue;
      // The flatter of the two one-sided differences, lest every step spoils the two pixels beside it.
      const auto flatter = [&](int a, int b) { return std::abs(a) < std::abs(b) ? a : b; };
      const double gx = unit * flatter(right - z, z - left), gy = unit * flatter(up - z, z - down);
      const double slope = std::hypot(gx, gy);
      ++surface;
      add_between(block(numbers, kSlope), std::atan(slope) / kRightAngle, 1);
      if (slope > 0.02) {
        const std::size_t steepness = slope < 0.5 ? 0 : slope < 1.5 ? 1 : 2;
        add_round(aspect.subspan(8 * steepness, 8), modulo_right_angle(std::atan2(gy, gx)), 1);
      }
      const double jump_x = unit * (right - left) / 2, jump_y = unit * (up - down) / 2;
      if (std::hypot(jump_x, jump_y) > kStep && slope < kStep) {
        add_round(edges.first(4), modulo_right_angle(std::atan2(jump_y, jump_x)), 1);
        ++steps;
      }
    }
  if (!(covered > 0)) return;
  divide(block(numbers, kSlope), surface);
  divide(aspect, surface);
  divide(block(numbers, kDepth), covered);
  divide(edges.first(4), steps);
  const double root = std::sqrt(covered);
  edges[4] = static_cast<float>(std::min(1.0, steps / (16 * root)));
  const auto extent = block(numbers, kExtent);
  const double width = most_x - least_x + 1, height = most_y - least_y + 1, n = size;
  double farthest = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (image.at(x, y) != 0) farthest = std::max(farthest, std::hypot(x - sum_x / covered, y - sum_y / covered));
  extent[0] = static_cast<float>(root / n);
  extent[1] = static_cast<float>(std::min(1.0, farthest / n));
  extent[2] = static_cast<float>(std::min(width, height) / n);
  extent[3] = static_cast<float>(std::max(width, height) / n);
}

/// The outline's directions and bends. Chords over several pixels, for the raster knows only eight directions.
void add_outline(const render::DepthImage& image, RichNumbers& numbers) {
  Mask mask(image.size);
  for (int y = 0; y < image.size; ++y)
    for (int x = 0; x < image.size; ++x) mask.pixels[mask.at(x, y)] = image.covered(x, y);
  const std::vector<Pixel> contour = outer_contour(mask);
  const std::size_t n = contour.size();
  if (n < 8) return;
  const auto direction = [&](std::size_t i, std::size_t way) {
    const Pixel a = contour[i % n], b = contour[(i + way) % n];
    return std::pair<double, double>(b.x - a.x, b.y - a.y);
  };
  const auto directions = block(numbers, kContour), bends = block(numbers, kBend);
  const std::size_t chord = std::clamp<std::size_t>(n / 100, 3, 9);
  const std::array<std::size_t, 2> ways{std::max<std::size_t>(n / 40, 3), std::max<std::size_t>(n / 10, 4)};
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [dx, dy] = direction(i, chord);
    if (dx == 0 && dy == 0) continue;
    total += 1;
    add_round(directions, modulo_right_angle(std::atan2(dy, dx)), 1);
  }
  divide(directions, total);
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const auto bins = bends.subspan(8 * w, 8);
    for (std::size_t i = 0; i < n; ++i) {
      const auto [ax, ay] = direction(i, ways[w]);
      const auto [bx, by] = direction(i + ways[w], ways[w]);
      const double turning = std::atan2(ax * by - ay * bx, ax * bx + ay * by);  // -pi to pi; inward is negative
      add_between(bins, turning / (2 * std::numbers::pi) + 0.5, 1);
    }
    divide(bins, static_cast<double>(n));
  }
}

}  // namespace

RichNumbers rich_view_numbers(const render::DepthImage& image) {
  RichNumbers numbers{};
  const ViewNumbers classic = view_numbers(image, {});
  std::ranges::copy(classic, numbers.begin());
  add_surface(image, numbers);
  add_outline(image, numbers);
  return numbers;
}

}  // namespace rectilin::retrieval
