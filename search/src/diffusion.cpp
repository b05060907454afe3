#include "rectilin/search/diffusion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rectilin::search {
namespace {

constexpr double kNoLink = 1e-12;  // share of the activation that counts as none

}  // namespace

std::vector<double> diffuse(std::span<const float> distances, std::size_t size, const DiffusionOptions& options) {
  const auto at = [&](std::size_t i, std::size_t j) { return static_cast<double>(distances[i * size + j]); };
  const std::size_t k = std::min(options.neighbours, size - 1);
  std::vector<std::vector<std::size_t>> linked(size);
  std::vector<double> scale(size);
  std::vector<std::size_t> order(size);
  for (std::size_t i = 0; i < size && k > 0; ++i) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(i));
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                      [&](std::size_t a, std::size_t b) { return std::pair(at(i, a), a) < std::pair(at(i, b), b); });
    scale[i] = at(i, order[k - 1]);
    for (std::size_t m = 0; m < k; ++m) {
      linked[i].push_back(order[m]);
      linked[order[m]].push_back(i);
    }
    order.resize(size);
  }
  struct Link {
    std::size_t to;
    double weight;
  };
  std::vector<std::vector<Link>> links(size);
  std::vector<double> degree(size);
  for (std::size_t i = 0; i < size; ++i) {
    std::ranges::sort(linked[i]);
    linked[i].erase(std::unique(linked[i].begin(), linked[i].end()), linked[i].end());
    for (const std::size_t j : linked[i]) {
      const double product = scale[i] * scale[j], square = at(i, j) * at(i, j);
      const double weight = product > 0 ? std::exp(-square / product) : (square > 0 ? 0 : 1);
      links[i].push_back({j, weight});
      degree[i] += weight;
    }
  }
  std::vector<double> f(size), next(size);
  f[0] = 1;
  for (int step = 0; step < options.steps; ++step) {
    for (std::size_t i = 0; i < size; ++i) {
      double sum = 0;
      for (const Link& link : links[i])
        if (link.weight > 0) sum += link.weight / std::sqrt(degree[i] * degree[link.to]) * f[link.to];
      next[i] = options.spread * sum + (i == 0 ? 1 - options.spread : 0);
    }
    std::swap(f, next);
  }
  for (std::size_t i = 1; i < size; ++i)
    if (degree[i] > 0) f[i] *= std::sqrt(degree[0] / degree[i]);
  return f;
}

std::vector<Neighbour> diffused_nearest(const NearestSearch& search, const Parts& query, std::size_t n,
                                        const std::function<bool(std::size_t)>& keep, const DiffusionOptions& options) {
  std::vector<Neighbour> pool = search.nearest(query, std::max(n, options.pool), keep);
  const std::size_t size = std::min(options.pool, pool.size()) + 1;
  std::vector<float> distances(size * size);
  const auto set = [&](std::size_t i, std::size_t j, double d) {
    distances[i * size + j] = distances[j * size + i] = static_cast<float>(d);
  };
  for (std::size_t i = 1; i < size; ++i) set(0, i, pool[i - 1].distance);
  tbb::parallel_for(std::size_t{1}, size, [&](std::size_t i) {
    const Parts own = search.parts_of(pool[i - 1].member);
    for (std::size_t j = 1; j < i; ++j) set(i, j, search.distance(own, pool[j - 1].member));
  });
  const std::vector<double> f = diffuse(distances, size, options);
  const std::size_t last = std::min(options.neighbours, size - 1);
  const double scale = last > 0 ? std::max(pool[last - 1].distance, 1e-9) : 1;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    const double share = i + 1 < size ? f[i + 1] / f[0] : 0;
    pool[i].distance = options.straight * pool[i].distance / scale - std::log(std::clamp(share, kNoLink, 1.0));
  }
  std::ranges::stable_sort(pool, {}, &Neighbour::distance);
  if (pool.size() > n) pool.resize(n);
  return pool;
}

}  // namespace rectilin::search
