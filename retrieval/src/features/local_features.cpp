#include "features/local_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rectilin::retrieval {
namespace {

constexpr int kPatch = 16, kStepOfGrid = 4, kDirections = 8, kCells = 4;

struct Gradient {
  float size, direction;  // direction in [0, 1) of a turn
};

/// Depths from 0 to 1 at some scale, and which pixels are background.
struct Level {
  int size;
  std::vector<float> depth, covered;
};

Level halved(const Level& level) {
  Level half{level.size / 2, {}, {}};
  for (int y = 0; y < half.size; ++y)
    for (int x = 0; x < half.size; ++x) {
      const auto at = static_cast<std::size_t>(2 * y * level.size + 2 * x);
      const auto below = at + static_cast<std::size_t>(level.size);
      const auto mean = [&](const std::vector<float>& v) { return (v[at] + v[at + 1] + v[below] + v[below + 1]) / 4; };
      half.depth.push_back(mean(level.depth));
      half.covered.push_back(mean(level.covered));
    }
  return half;
}

std::vector<Gradient> gradients(const Level& level) {
  const int n = level.size;
  const float steepest = 1.0f / static_cast<float>(n);  // half of the range over half of the picture is 45 degrees
  std::vector<Gradient> all(static_cast<std::size_t>(n * n));
  const auto depth = [&](int x, int y) {
    return level.depth[static_cast<std::size_t>(std::clamp(y, 0, n - 1) * n + std::clamp(x, 0, n - 1))];
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const float gx = (depth(x + 1, y) - depth(x - 1, y)) / 2, gy = (depth(x, y - 1) - depth(x, y + 1)) / 2;
      const float size = std::sqrt(gx * gx + gy * gy);
      if (size < 0.02f * steepest) continue;
      const double turn = std::atan2(static_cast<double>(gy), static_cast<double>(gx)) / (2 * std::numbers::pi);
      all[static_cast<std::size_t>(y * n + x)] = {std::min(size, 2 * steepest),
                                                  static_cast<float>(turn - std::floor(turn))};
    }
  return all;
}

/// The patch's main direction, as a share of a turn.
float main_direction(const std::vector<Gradient>& all, int n, int left, int top) {
  std::array<float, 36> bins{};
  for (int y = 0; y < kPatch; ++y)
    for (int x = 0; x < kPatch; ++x) {
      const Gradient& g = all[static_cast<std::size_t>((top + y) * n + left + x)];
      bins[static_cast<std::size_t>(std::min(35.0f, g.direction * 36))] += g.size;
    }
  std::array<float, 36> smooth{};
  for (std::size_t k = 0; k < 36; ++k)
    smooth[k] =
        bins[(k + 34) % 36] + 4 * bins[(k + 35) % 36] + 6 * bins[k] + 4 * bins[(k + 1) % 36] + bins[(k + 2) % 36];
  const auto k = static_cast<std::size_t>(std::ranges::max_element(smooth) - smooth.begin());
  return (static_cast<float>(k) + 0.5f) / 36;
}

/// How a sample adds to cells, for a patch turned by a share of a turn.
class Sampler {
 public:
  explicit Sampler(float turn) : turn_(turn) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(turn);
    const double c = std::cos(angle), s = std::sin(angle);
    for (int y = 0; y < kPatch; ++y)
      for (int x = 0; x < kPatch; ++x) {
        const double dx = x - (kPatch - 1) / 2.0, dy = (kPatch - 1) / 2.0 - y;  // y up
        // The patch is turned back: its main direction becomes that of x.
        const double u = (c * dx + s * dy) / kCells + (kCells - 1) / 2.0,
                     v = (-s * dx + c * dy) / kCells + (kCells - 1) / 2.0;
        const double weight = std::exp(-(dx * dx + dy * dy) / (2.0 * 8 * 8));
        Sample& sample = samples_[static_cast<std::size_t>(y * kPatch + x)];
        const double iu = std::floor(u), iv = std::floor(v);
        for (int k = 0; k < 4; ++k) {
          const int a = static_cast<int>(iu) + k % 2, b = static_cast<int>(iv) + k / 2;
          const double wu = k % 2 ? u - iu : 1 - (u - iu), wv = k / 2 ? v - iv : 1 - (v - iv);
          const bool inside = a >= 0 && a < kCells && b >= 0 && b < kCells;
          sample.cell[static_cast<std::size_t>(k)] = inside ? (b * kCells + a) * kDirections : 0;
          sample.weight[static_cast<std::size_t>(k)] = inside ? static_cast<float>(weight * wu * wv) : 0;
        }
      }
  }

  LocalFeature operator()(const std::vector<Gradient>& all, int n, int left, int top) const {
    LocalFeature f{};
    for (int y = 0; y < kPatch; ++y)
      for (int x = 0; x < kPatch; ++x) {
        const Gradient& g = all[static_cast<std::size_t>((top + y) * n + left + x)];
        if (g.size == 0) continue;
        float at = (g.direction - turn_) * kDirections;
        if (at < 0) at += kDirections;
        const int low = static_cast<int>(at) % kDirections, high = (low + 1) % kDirections;
        const float part = at - std::floor(at);
        const Sample& sample = samples_[static_cast<std::size_t>(y * kPatch + x)];
        for (std::size_t k = 0; k < 4; ++k) {
          const float w = sample.weight[k] * g.size;
          f[static_cast<std::size_t>(sample.cell[k] + low)] += w * (1 - part);
          f[static_cast<std::size_t>(sample.cell[k] + high)] += w * part;
        }
      }
    return f;
  }

 private:
  struct Sample {
    std::array<int, 4> cell;
    std::array<float, 4> weight;
  };
  float turn_;
  std::array<Sample, kPatch * kPatch> samples_;
};

const std::vector<Sampler>& samplers() {
  static const std::vector<Sampler> all = [] {
    std::vector<Sampler> s;
    for (int k = 0; k < 36; ++k) s.emplace_back((static_cast<float>(k) + 0.5f) / 36);
    for (int k = 0; k < 4; ++k) s.emplace_back(static_cast<float>(k) / 4);
    return s;
  }();
  return all;
}

}  // namespace

void visit_local_features(const render::DepthImage& image, Turn turn,
                          const std::function<void(const LocalFeature&)>& take) {
  Level level{image.size, {}, {}};
  for (const std::uint16_t z : image.depth) {
    level.depth.push_back(static_cast<float>(z) / 65535.0f);
    level.covered.push_back(z != 0 ? 1.0f : 0.0f);
  }
  for (int scale = 0; scale < 3; ++scale) {
    level = halved(level);
    const int n = level.size;
    if (n < kPatch) return;
    const std::vector<Gradient> all = gradients(level);
    for (int top = 0; top + kPatch <= n; top += kStepOfGrid)
      for (int left = 0; left + kPatch <= n; left += kStepOfGrid) {
        float covered = 0;  // of the middle of the patch
        for (int y = 6; y < 10; ++y)
          for (int x = 6; x < 10; ++x) covered += level.covered[static_cast<std::size_t>((top + y) * n + left + x)];
        if (covered < 4) continue;
        std::size_t sampler = 36;
        if (turn != Turn::kNone) {
          const float main = main_direction(all, n, left, top);
          sampler = turn == Turn::kFree ? static_cast<std::size_t>(std::min(35.0f, main * 36))
                                        : 36 + static_cast<std::size_t>(std::min(3.0f, main * 4));
        }
        LocalFeature f = samplers()[sampler](all, n, left, top);
        float sum = 0;
        for (const float x : f) sum += x;
        if (!(sum > 0)) {
          // A plane that faces the viewer has no gradients: a feature of its own, all alike.
          f.fill(1.0f / kLocal);
          sum = 1;
        }
        for (float& x : f) x = std::sqrt(x / sum);
        take(f);
      }
  }
}

}  // namespace rectilin::retrieval
