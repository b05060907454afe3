// Cuts by runs against long double sums, on vectors with and without order.
#include <algorithm>
#include <cmath>

#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/run_sum.h"
#include "support/catch.h"
#include "support/sum_fixtures.h"

using namespace rectilin;

namespace {

/// Vectors that turn slowly, so that most great circles miss most runs.
Directions helix(std::size_t size) {
  Directions result(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(size);
    result[i] = (1 + 0.5 * std::sin(40 * t)) * Vector3(std::cos(6 * t), std::sin(6 * t), 0.2 + t);
  }
  return result;
}

Directions probes(const Directions& vectors) {
  Directions u = gaussian(12, 7);
  u.insert(u.end(), {Vector3::UnitX(), -Vector3::UnitZ(), {0.6, 0.8, 1e-17}, {0, 0, 1e-200}, {3e100, 4e100, 0}});
  // Across a vector, where its sign is a matter of rounding, and along the first.
  for (const std::size_t i : {std::size_t{0}, vectors.size() / 2})
    if (i < vectors.size()) u.insert(u.end(), {vectors[i].unitOrthogonal(), vectors[i]});
  return u;
}

void check(const Directions& vectors) {
  const AreaVectors area = make_vectors(vectors);
  const Directions u = probes(vectors);
  for (const std::string& name : instruction_sets()) {
    CAPTURE(name, vectors.size());
    const ScopedInstructionSet target(name);
    const RunSum sum(area);
    Directions g(u.size());
    sum.cuts(u, g);
    std::vector<double> h(u.size());
    sum.values(u, h);
    for (std::size_t k = 0; k < u.size(); ++k) {
      CAPTURE(u[k].transpose());
      const double bound = RunSum::kErrorBound * area.total;
      CHECK(std::abs(h[k] - exact_value(vectors, u[k])) <= bound * u[k].stableNorm());
      CHECK(std::abs(g[k].dot(u[k]) - exact_value(vectors, u[k])) <= bound * u[k].stableNorm());
      for (const Vector3& w : u) CHECK(g[k].dot(w) <= exact_value(vectors, w) + bound * w.stableNorm());
    }
  }
}

}  // namespace

TEST_CASE("sums by runs are exact at every size", "[run_sum]") {
  for (std::size_t size = 0; size <= 40; ++size) check(gaussian(size, 1));
  for (const std::size_t size : {127u, 128u, 129u, 1023u, 1024u, 1025u, 5000u}) {
    check(gaussian(size, 2));
    check(helix(size));
  }
}

TEST_CASE("sums by runs bear vectors that cancel, vanish or are parallel", "[run_sum]") {
  const Vector3 v = Vector3(1, 2, 3).normalized();
  Directions opposite, tilted, fading = helix(400);
  for (std::size_t i = 0; i < 400; ++i) {
    opposite.push_back(i % 2 == 0 ? v : -v);
    tilted.push_back(v.unitOrthogonal() + (static_cast<double>(i) - 200) * 1e-18 * v);
    fading[i] *= std::pow(10.0, -0.8 * static_cast<double>(i));  // down to 1e-320
  }
  for (const Directions& vectors : {opposite, tilted, fading, Directions(400, v)}) check(vectors);
}

TEST_CASE("cuts by runs do not depend on threads or batches", "[run_sum]") {
  const AreaVectors vectors = make_vectors(helix(20000));
  const RunSum sum(vectors);
  const Directions u = gaussian(300, 5);
  Directions one(u.size()), many(u.size()), single(u.size());
  with_threads(1, [&] { sum.cuts(u, one); });
  with_threads(4, [&] { sum.cuts(u, many); });
  for (std::size_t k = 0; k < u.size(); ++k) sum.cuts({&u[k], 1}, {&single[k], 1});
  CHECK(one == many);
  CHECK(one == single);
}

TEST_CASE("a mesh's cuts by runs touch its values", "[run_sum]") {
  const ProjectedArea objective(make_vectors(helix(3000)));
  const ProjectedArea flat(make_vectors(helix(3000)), "flat", SumMethod::kFlat);
  Random random(3);
  std::vector<Rotation> at(50);
  std::ranges::generate(at, [&] { return random_rotation(random); });
  std::vector<Cut> by_runs(at.size()), by_vectors(at.size());
  objective.cuts(at, by_runs);
  flat.cuts(at, by_vectors);
  for (std::size_t i = 0; i < at.size(); ++i) {
    CHECK(by_runs[i].value == Approx(flat.value(at[i])).epsilon(1e-12));
    CHECK((by_runs[i].gradient - by_vectors[i].gradient).norm() <= 1e-12);
  }
}
