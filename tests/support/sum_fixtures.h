// What the tests of the sums share: area vectors, what long double says of them, and threads.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <random>
#include <vector>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/direction_tree.h"

namespace rectilin {

using Directions = std::vector<Vector3>;

/// As they are: in their order, none merged or dropped.
inline AreaVectors make_vectors(const Directions& vectors) {
  AreaVectors result;
  for (const Vector3& v : vectors) {
    result.x.push_back(v.x());
    result.y.push_back(v.y());
    result.z.push_back(v.z());
    result.total += v.stableNorm();
  }
  result.faces = vectors.size();
  return result;
}

inline Directions gaussian(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Directions result(size);
  for (Vector3& v : result) v = Vector3(normal(random), normal(random), normal(random));
  return result;
}

inline double exact_value(const Directions& vectors, const Vector3& u) {
  long double sum = 0;
  for (const Vector3& v : vectors) {
    sum += std::abs(static_cast<long double>(u.x()) * v.x() + static_cast<long double>(u.y()) * v.y() +
                    static_cast<long double>(u.z()) * v.z());
  }
  return static_cast<double>(sum);
}

inline std::vector<double> values(const DirectionTree& tree, const Directions& u, double resolution = 0) {
  std::vector<double> h(u.size());
  tree.values(u, h, resolution);
  return h;
}

inline Directions cuts(const DirectionTree& tree, const Directions& u, double resolution = 0) {
  Directions g(u.size());
  tree.cuts(u, g, resolution);
  return g;
}

template <class Function>
auto with_threads(int threads, const Function& function) {
  // More threads than cores are fine here, but TBB wants to be told.
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  return arena.execute(function);
}

}  // namespace rectilin
