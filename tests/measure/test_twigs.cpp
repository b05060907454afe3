// Trees with twigs against long double sums, and against the same trees without them.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rectilin/measure/direction_tree.h"
#include "support/catch.h"
#include "support/random_meshes.h"
#include "support/sum_fixtures.h"

using namespace rectilin;

namespace {

constexpr DirectionTree::TwigRule kNone = {.fewest = 1 << 30};

/// In their order on the sphere, without which nodes would be wide.
AreaVectors sorted(Directions vectors) { return area_vectors(std::move(vectors)); }

double exact(const AreaVectors& vectors, const Vector3& u) {
  Directions all;
  for (std::size_t i = 0; i < vectors.size(); ++i) all.emplace_back(vectors.x[i], vectors.y[i], vectors.z[i]);
  return exact_value(all, u);
}

/// What a tree takes after the first value, which makes the twigs.
std::size_t bytes(const AreaVectors& vectors, const DirectionTree::TwigRule& rule) {
  const DirectionTree tree(vectors, rule);
  values(tree, {Vector3::UnitX()});
  return tree.bytes();
}

/// The error, up to a tenth, from which on a tree of these vectors gets twigs.
double least_error(const AreaVectors& vectors) {
  const std::size_t without = bytes(vectors, kNone);
  double error = 1e-12;
  while (bytes(vectors, {.fewest = 0, .error = error}) == without) {
    error *= 1.1;
    REQUIRE(error < 1e-3);
  }
  return error;
}

/// Directions close to each other in clusters, of lengths from 1 to 1e-6.
Directions clustered(std::size_t clusters, std::size_t members) {
  Random random(3);
  Directions result;
  for (std::size_t i = 0; i < clusters; ++i) {
    const Vector3 axis = test::random_vector(random).normalized();
    for (std::size_t j = 0; j < members; ++j)
      result.push_back((axis + 0.02 * test::random_vector(random)) * std::pow(10.0, -6 * random.uniform()));
  }
  return result;
}

/// Directions of which one in sixteen is close to the plane across `axis`, and long.
Directions banded(const Vector3& axis, std::size_t size) {
  Directions result = gaussian(size, 5);
  for (std::size_t i = 0; i < size; i += 16) result[i] = 10 * (result[i] - 0.97 * result[i].dot(axis) * axis);
  return result;
}

}  // namespace

TEST_CASE("values with twigs err by no more than is promised, and far less in the mean", "[twigs]") {
  for (const Directions& vectors : {gaussian(60'000, 1), gaussian(100'001, 2), clustered(20, 4000)}) {
    const AreaVectors area = sorted(vectors);
    const double error = least_error(area);
    CAPTURE(area.size(), error);
    Directions u = gaussian(12, 3);
    u.insert(u.end(), {Vector3::UnitX(), -Vector3::UnitY(), Vector3::UnitZ(), {1, 1, 0}, {0.6, -0.8, 1e-17}});
    for (const std::string& name : instruction_sets()) {
      CAPTURE(name);
      ScopedInstructionSet target(name);
      const DirectionTree tree(area, {.fewest = 0, .error = error});
      const auto h = values(tree, u), without = values(DirectionTree(area, kNone), u);
      double sum = 0;
      std::size_t changed = 0;
      for (std::size_t k = 0; k < u.size(); ++k) {
        const double miss = std::abs(h[k] - exact(area, u[k])) / (area.total * u[k].norm());
        CHECK(miss <= DirectionTree::kErrorBound + error);
        sum += miss;
        changed += h[k] != without[k];
      }
      CHECK(sum / static_cast<double>(u.size()) < error / 32);
      CHECK(changed > u.size() / 2);  // or no twigs were read
    }
  }
}

TEST_CASE("twigs bear degenerate vectors", "[twigs]") {
  const Vector3 v = Vector3(1, 2, 3).normalized();
  Directions opposite, tilted, sparse(5000, Vector3::Zero()), spread, gaps;
  for (int i = 0; i < 5000; ++i) {
    opposite.push_back(i % 2 == 0 ? v : -v);
    tilted.push_back(v.unitOrthogonal() + (i - 2500) * 1e-18 * v);
  }
  sparse[2500] = v;
  for (const Vector3& noise : gaussian(5000, 13)) {
    spread.push_back(std::pow(10.0, -0.02 * static_cast<double>(spread.size())) * (v + 1e-3 * noise));
    gaps.push_back(gaps.size() % 3 == 0 ? Vector3(v + 1e-3 * noise) : Vector3::Zero());
  }
  std::size_t changed = 0;
  for (const Directions& vectors : {opposite, tilted, sparse, spread, gaps, Directions(5000, 1e-170 * v),
                                    Directions(5000, 1e-220 * v), Directions(5000, Vector3::Zero())}) {
    const AreaVectors area = make_vectors(vectors);
    Directions u = gaussian(10, 14);
    u.insert(u.end(), {v, v.unitOrthogonal(), {0, 0, 1e-200}, {3e100, 4e100, 0}});
    for (const double lean : {1e-3, 2e-3, 3e-3}) u.push_back(v.unitOrthogonal() + lean * v);
    const auto h = values(DirectionTree(area, {.fewest = 0, .error = 1}), u),
               without = values(DirectionTree(area, kNone), u);
    // The clusters are a thousandth wide: so far can R of their leaves be from zero, and 2^-17 R from what is right.
    for (std::size_t k = 0; k < u.size(); ++k) {
      CHECK(std::abs(h[k] - exact_value(vectors, u[k])) <= 3e-8 * area.total * u[k].stableNorm());
      changed += h[k] != without[k];
    }
  }
  CHECK(changed >= 4);  // both clusters are met in part
}

TEST_CASE("directions for which twigs are not accurate enough do without them", "[twigs]") {
  const Vector3 axis = Vector3(2, 3, -1).normalized();
  const AreaVectors area = sorted(banded(axis, 100'000));
  const DirectionTree tree(area, {.fewest = 0, .error = least_error(area)});
  Directions u = gaussian(20, 4);
  u.push_back(axis);
  const auto h = values(tree, u), without = values(DirectionTree(area, kNone), u);
  CHECK(h.back() == without.back());
  CHECK(h != without);
}

TEST_CASE("twigs change neither cuts nor values of a resolution", "[twigs]") {
  const AreaVectors area = sorted(gaussian(100'000, 7));
  const DirectionTree tree(area, {.fewest = 0, .error = 1e-6}), without(area, kNone);
  const Directions u = gaussian(20, 8);
  CHECK(values(tree, u) != values(without, u));
  CHECK(cuts(tree, u) == cuts(without, u));
  CHECK(values(tree, u, 0.01) == values(without, u, 0.01));
}

TEST_CASE("twigs are made with the first value, whoever asks for it", "[twigs]") {
  const AreaVectors area = sorted(gaussian(100'000, 15));
  const DirectionTree tree(area, {.fewest = 0, .error = 1e-6}), other = tree;
  const std::size_t before = tree.bytes();
  cuts(tree, {Vector3::UnitX()});
  CHECK(tree.bytes() == before);
  const Directions u = gaussian(8, 16);
  std::vector<std::vector<double>> h(64);
  with_threads(8, [&] {
    tbb::parallel_for(std::size_t{0}, h.size(), [&](std::size_t i) { h[i] = values(i % 2 == 0 ? tree : other, u); });
  });
  CHECK(tree.bytes() > before);
  CHECK(std::ranges::all_of(h, [&](const auto& one) { return one == values(tree, u); }));
}

TEST_CASE("bits of values with twigs do not depend on threads", "[twigs]") {
  const AreaVectors area = sorted(gaussian(100'000, 9));
  const DirectionTree::TwigRule rule = {.fewest = 0, .error = 1e-6};
  const Directions u = gaussian(200, 10);
  const auto h = with_threads(1, [&] { return values(DirectionTree(area, rule), u); });
  CHECK(with_threads(8, [&] { return values(DirectionTree(area, rule), u); }) == h);
  CHECK(values(DirectionTree(area, rule), {u[7]})[0] == h[7]);
}

TEST_CASE("a tree gets no twigs where they would seldom be of use", "[twigs]") {
  const AreaVectors coarse = sorted(gaussian(3000, 11)), fine = sorted(gaussian(100'000, 12));
  CHECK(bytes(coarse, {.fewest = 0, .error = 1}) == bytes(coarse, kNone));  // nodes are wide
  CHECK(bytes(fine, {.fewest = 0, .error = 1e-11}) == bytes(fine, kNone));  // not accurate enough
  CHECK(bytes(fine, {.fewest = 100'001, .error = 1}) == bytes(fine, kNone));
  CHECK(bytes(fine, {.fewest = 100'000, .error = 1}) > bytes(fine, kNone));
}
