#include "rectilin/search/diffusion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "reciprocal.h"
#include "rectilin/retrieval/scores.h"

namespace rectilin::search {
namespace {

constexpr double kNoLink = 1e-12;  // share of the activation that counts as none

}  // namespace

std::vector<double> diffuse(std::span<const float> distances, std::size_t size, const DiffusionOptions& options) {
  const auto at = [&](std::size_t i, std::size_t j) { return static_cast<double>(distances[i * size + j]); };
  const std::size_t k = std::min(options.neighbours, size - 1);
  const std::size_t expand = std::clamp<std::size_t>(options.expand, 1, size);
  const Rankings nearest = rankings(distances, size, std::max(k + 1, expand));
  std::vector<std::vector<std::size_t>> linked(size);
  std::vector<double> scale(size);
  for (std::size_t i = 0; i < size && k > 0; ++i) {
    scale[i] = at(i, nearest[i][k]);
    for (std::size_t m = 1; m <= k; ++m) {
      linked[i].push_back(nearest[i][m]);
      linked[nearest[i][m]].push_back(i);
    }
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
  // Values over the root of the weight; of shapes without links, whose activation stays with them, as they are.
  std::vector<double> root(size, 1);
  for (std::size_t i = 0; i < size; ++i)
    if (degree[i] > 0) root[i] = std::sqrt(degree[i]);
  std::vector<double> start(size), f, next(size);
  for (std::size_t m = 0; m < expand; ++m)
    start[nearest[0][m]] = root[0] * root[0] / root[nearest[0][m]] / static_cast<double>(expand);
  f = start;
  for (int step = 0; step < options.steps; ++step) {
    for (std::size_t i = 0; i < size; ++i) {
      double sum = 0;
      for (const Link& link : links[i])
        if (link.weight > 0) sum += link.weight / (root[i] * root[link.to]) * f[link.to];
      next[i] = options.spread * sum + (1 - options.spread) * start[i];
    }
    std::swap(f, next);
  }
  for (std::size_t i = 0; i < size; ++i) f[i] /= root[i];
  std::vector<double> means(size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t m = 0; m < expand; ++m) means[i] += f[nearest[i][m]] / static_cast<double>(expand);
  return means;
}

std::vector<double> collection_ranking(std::span<const float> distances, std::size_t size,
                                       const DiffusionOptions& options) {
  const std::vector<double> f = diffuse(distances, size, options);
  const double most = std::ranges::max(f);
  const std::size_t last = std::min(options.neighbours, size - 1);
  const double scale = std::max(static_cast<double>(distances[rankings(distances, size, last + 1)[0][last]]), 1e-9);
  std::vector<double> jaccard(size);
  if (options.reciprocal > 0) jaccard = reciprocal_distances(distances, size);
  std::vector<double> result(size);
  for (std::size_t i = 1; i < size; ++i)
    result[i] = options.straight * static_cast<double>(distances[i]) / scale + options.reciprocal * jaccard[i] -
                std::log(std::clamp(f[i] / most, kNoLink, 1.0));
  return result;
}

namespace {

/// Gives the members of a pool, nearest to the query first, their distances by the collection. `distances` are those of
/// the query and of the first size - 1 members; beyond them the distance alone counts.
void rank_pool(std::vector<Neighbour>& pool, std::span<const float> distances, std::size_t size,
               const DiffusionOptions& options) {
  const std::vector<double> ranked = collection_ranking(distances, size, options);
  const double beyond = -std::log(kNoLink) + options.reciprocal;  // nothing there gets a part of the activation
  const double scale = size > 1 ? std::max(pool[std::min(options.neighbours, size - 1) - 1].distance, 1e-9) : 1;
  for (std::size_t i = 0; i < pool.size(); ++i)
    pool[i].distance = i + 1 < size ? ranked[i + 1] : options.straight * pool[i].distance / scale + beyond;
}

}  // namespace

retrieval::DistanceMatrix collection_distances(const retrieval::DistanceMatrix& distances,
                                               const DiffusionOptions& options) {
  retrieval::DistanceMatrix result(distances.size());
  tbb::parallel_for(std::size_t{0}, distances.size(), [&](std::size_t q) {
    std::vector<Neighbour> pool;
    for (const std::size_t i : retrieval::ranked({distances.row(q), distances.size()}, q))
      pool.push_back({i, static_cast<double>(distances.at(q, i))});
    const std::size_t size = std::min(options.pool, pool.size()) + 1;
    std::vector<std::size_t> members{q};
    for (std::size_t i = 1; i < size; ++i) members.push_back(pool[i - 1].member);
    std::vector<float> among;
    for (const std::size_t i : members)
      for (const std::size_t j : members) among.push_back(distances.at(i, j));
    rank_pool(pool, among, size, options);
    for (const Neighbour& n : pool) result.at(q, n.member) = static_cast<float>(n.distance);
  });
  return result;
}

std::vector<Neighbour> diffused_nearest(const NearestSearch& search, const Parts& query, std::size_t n,
                                        const std::function<bool(std::size_t)>& keep, const DiffusionOptions& options) {
  return diffused_pool(search, search.nearest(query, std::max(n, options.pool), keep), n, options);
}

std::vector<Neighbour> diffused_pool(const NearestSearch& search, std::vector<Neighbour> pool, std::size_t n,
                                     const DiffusionOptions& options) {
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
  rank_pool(pool, distances, size, options);
  std::ranges::stable_sort(pool, {}, &Neighbour::distance);
  if (pool.size() > n) pool.resize(n);
  return pool;
}

}  // namespace rectilin::search
