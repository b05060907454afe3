// The normal tree against long double sums, on meshes with and without order in their normals.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "rectilin/measure/direction_tree.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/projected_area.h"
#include "support/catch.h"
#include "support/random_meshes.h"
#include "support/sum_fixtures.h"
#include "tree/leaf_kernels.h"
#include "vectors/kd_order.h"

using namespace rectilin;

namespace {

/// The upper half of an ellipsoid's normals, square by square of a grid: neighbours are close
/// together.
Directions ellipsoid(std::size_t squares) {
  Directions result;
  constexpr std::size_t kSide = 8;
  for (std::size_t square = 0; square < squares * squares; ++square) {
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      const double row = static_cast<double>(square / squares * kSide + i / kSide) + 0.5;
      const double column = static_cast<double>(square % squares * kSide + i % kSide) + 0.5;
      const double height = row / static_cast<double>(squares * kSide);
      const double angle = 2 * std::numbers::pi * column / static_cast<double>(squares * kSide);
      const double radius = std::sqrt(1 - height * height);
      result.emplace_back(0.5 * radius * std::cos(angle), 0.7 * radius * std::sin(angle), height);
    }
  }
  return result;
}

/// Random directions, extreme ones, and some across which the given vectors lie.
Directions tree_test_directions(const Directions& vectors) {
  Directions u = gaussian(10, 99);
  u.insert(
      u.end(),
      {Vector3::UnitX(), Vector3::UnitY(), -Vector3::UnitZ(), {0.6, 0.8, 1e-17}, {0, 0, 1e-200}, {3e100, 4e100, 0}});
  for (const std::size_t i : {std::size_t{0}, vectors.size() / 2}) {
    if (i < vectors.size() && vectors[i] != Vector3::Zero())
      u.push_back(vectors[i].stableNormalized().unitOrthogonal());
  }
  return u;
}

void check_exact(const Directions& vectors) {
  const AreaVectors area = make_vectors(vectors);
  const Directions u = tree_test_directions(vectors);
  std::vector<double> exact;
  for (const Vector3& w : u) exact.push_back(exact_value(vectors, w));
  for (const std::string& name : instruction_sets()) {
    CAPTURE(name, vectors.size());
    ScopedInstructionSet target(name);
    const DirectionTree tree(area);
    const auto h = values(tree, u);
    const auto g = cuts(tree, u);
    for (std::size_t k = 0; k < u.size(); ++k) {
      CAPTURE(u[k].transpose());
      const double bound = DirectionTree::kErrorBound * area.total;
      CHECK(std::abs(h[k] - exact[k]) <= bound * u[k].stableNorm());
      CHECK(std::abs(g[k].dot(u[k]) - exact[k]) <= bound * u[k].stableNorm());
      for (std::size_t j = 0; j < u.size(); ++j) {
        CHECK(g[k].dot(u[j]) <= exact[j] + bound * u[j].stableNorm());
      }
    }
  }
}

}  // namespace

TEST_CASE("the tree's sums and cuts are exact at every size", "[direction_tree]") {
  for (std::size_t size = 0; size <= 33; ++size) check_exact(gaussian(size, 1));
  for (const std::size_t size : {63u, 64u, 65u, 511u, 513u, 4097u, 40000u}) {
    check_exact(gaussian(size, 2));
  }
  check_exact(ellipsoid(2));
  check_exact(ellipsoid(24));
}

TEST_CASE("the vectors of a leaf point to one side whatever their signs were", "[direction_tree]") {
  Random random(21);
  const Vector3 axis = Vector3(3, -1, 2).normalized();
  for (const std::string& name : instruction_sets()) {
    const ScopedInstructionSet target(name);
    for (const std::size_t size : {0u, 1u, 7u, 8u, 9u, 16u, 203u}) {
      CAPTURE(name, size);
      std::vector<double> x, y, z, lengths(size / kLeaf + 1);
      for (std::size_t i = 0; i < size; ++i) {
        const Vector3 v = (axis + 0.01 * Vector3(random.normal(), random.normal(), random.normal())) *
                          (random.below(2) == 0 ? -1 : 1);
        x.push_back(v.x()), y.push_back(v.y()), z.push_back(v.z());
        lengths[i / kLeaf] += std::abs(axis.dot(v));
      }
      std::vector<DirectionLeaf> leaves(lengths.size());
      std::vector<Vector3> sums(lengths.size(), Vector3::Zero());
      fill_leaves({x.data(), y.data(), z.data(), size}, leaf_unit(1), leaves.data(), sums.data());
      for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
        REQUIRE(axis.dot(sums[leaf]) == Approx(lengths[leaf]).epsilon(1e-12));
        for (std::size_t i = leaf * kLeaf; i < (leaf + 1) * kLeaf && i < size; ++i) {
          const std::size_t j = i % kLeaf;
          const double units = 256.0 * leaves[leaf].high[0][j] + leaves[leaf].low[0][j];
          const auto exponent = static_cast<int>(leaf_unit(1)) - 1023 - leaves[leaf].exponent[j];
          REQUIRE(std::ldexp(units, exponent) == Approx(std::copysign(x[i], axis.x())).epsilon(1e-11));
        }
      }
    }
  }
}

TEST_CASE("errors of the tree's shortened vectors average out", "[direction_tree]") {
  for (const Directions& vectors : {ellipsoid(4), ellipsoid(24), gaussian(5000, 13)}) {
    const AreaVectors area = make_vectors(vectors);
    const DirectionTree tree(area);
    const Directions u = gaussian(20, 14);
    const auto h = values(tree, u);
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double exact = exact_value(vectors, u[k]);
      CHECK(std::abs(h[k] - exact) <= 1e-13 * exact);
    }
  }
}

TEST_CASE("the leaves of a tree hold squares of directions", "[direction_tree]") {
  Random random(13);
  std::vector<Vector3> vectors(80'000);
  for (Vector3& v : vectors) v = test::random_vector(random).normalized();
  const AreaVectors sorted = area_vectors(std::move(vectors));
  const std::vector<double> run = arranged({sorted.x.data(), sorted.y.data(), sorted.z.data(), kRun});
  const auto vector = [&](std::size_t i) { return Vector3(run[i], run[kRun + i], run[2 * kRun + i]); };
  double sines = 0;  // the largest between the first and another vector of each leaf, summed
  for (std::size_t begin = 0; begin < kRun; begin += kLeaf) {
    double largest = 0;
    for (std::size_t i = begin + 1; i < begin + kLeaf; ++i)
      largest = std::max(largest, vector(begin).cross(vector(i)).norm());
    sines += largest;
  }
  const double side = std::sqrt(kLeaf * 2 * std::numbers::pi / 80'000);
  REQUIRE(sines * kLeaf / kRun < 1.1 * side);
}

TEST_CASE("the tree bears degenerate vectors", "[direction_tree]") {
  const Vector3 v = Vector3(1, 2, 3).normalized();
  Directions opposite, tilted;
  for (std::size_t i = 0; i < 1000; ++i) {
    opposite.push_back(i % 2 == 0 ? v : -v);
    // Angles of rounding size on both sides of the plane across v.
    tilted.push_back(v.unitOrthogonal() + (static_cast<double>(i) - 500) * 1e-18 * v);
  }
  Directions spread = gaussian(3000, 3);
  for (std::size_t i = 0; i < spread.size(); ++i) {
    spread[i] *= std::pow(10.0, -0.1 * static_cast<double>(i));  // down to 1e-300 and below
  }
  check_exact(opposite);
  check_exact(tilted);
  check_exact(spread);
  check_exact(Directions(1000, v));
  check_exact(Directions(1000, Vector3::Zero()));
  check_exact(Directions(1000, 1e-170 * v));
  Directions sparse(1000, Vector3::Zero());
  sparse[500] = v;
  check_exact(sparse);
}

TEST_CASE("nodes that cancel are opened", "[direction_tree]") {
  // Sums that vanish, or nearly so, say nothing about the vectors.
  Directions vectors;
  for (const Vector3& v : gaussian(700, 4)) {
    vectors.push_back(v);
    vectors.push_back(-v);
  }
  check_exact(vectors);
}

TEST_CASE("a resolution gives lower bounds and valid cuts", "[direction_tree]") {
  for (const Directions& vectors : {ellipsoid(16), gaussian(5000, 5)}) {
    const AreaVectors area = make_vectors(vectors);
    const DirectionTree tree(area);
    const Directions u = tree_test_directions(vectors);
    const auto exact = values(tree, u);
    const double bound = DirectionTree::kErrorBound * area.total;
    for (const double resolution : {1e-6, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 1.5}) {
      CAPTURE(resolution);
      const auto h = values(tree, u, resolution);
      const auto g = cuts(tree, u, resolution);
      for (std::size_t k = 0; k < u.size(); ++k) {
        CHECK(h[k] <= exact[k] + bound * u[k].stableNorm());
        // An unopened node lies within 2 resolution of the circle, where |u . v| < sin(that) |u|
        // |v|.
        CHECK(h[k] >= exact[k] - (4 * resolution * area.total + bound) * u[k].stableNorm());
        CHECK(std::abs(g[k].dot(u[k]) - h[k]) <= bound * u[k].stableNorm());
        for (std::size_t j = 0; j < u.size(); ++j) {
          CHECK(g[k].dot(u[j]) <= exact[j] + bound * u[j].stableNorm());
        }
      }
    }
  }
}

TEST_CASE("order changes a tree's speed, not its sums", "[direction_tree]") {
  Directions vectors = ellipsoid(16);
  const Directions u = gaussian(20, 6);
  const auto sorted = values(DirectionTree(make_vectors(vectors)), u);
  std::shuffle(vectors.begin(), vectors.end(), std::mt19937(7));
  const AreaVectors area = make_vectors(vectors);
  const auto shuffled = values(DirectionTree(area), u);
  for (std::size_t k = 0; k < u.size(); ++k) {
    CHECK(std::abs(sorted[k] - shuffled[k]) <= 2 * DirectionTree::kErrorBound * area.total * u[k].stableNorm());
  }
}

TEST_CASE("tree bits depend neither on threads nor on the other directions", "[direction_tree]") {
  const AreaVectors area = make_vectors(ellipsoid(40));
  const Directions u = gaussian(300, 8);
  const DirectionTree tree = with_threads(1, [&] { return DirectionTree(area); });
  const auto h = with_threads(1, [&] { return values(tree, u); });
  const auto g = with_threads(1, [&] { return cuts(tree, u); });
  for (const int threads : {2, 8}) {
    const DirectionTree other = with_threads(threads, [&] { return DirectionTree(area); });
    CHECK(with_threads(threads, [&] { return values(other, u); }) == h);
    CHECK(with_threads(threads, [&] { return cuts(other, u); }) == g);
  }
  for (std::size_t k = 0; k < u.size(); k += 11) CHECK(values(tree, {u[k]})[0] == h[k]);
}

TEST_CASE("a direction across which nearly all vectors lie gets the flat sum", "[direction_tree]") {
  const Vector3 axis = Vector3(0.3, 0.5, 0.7).normalized();
  const Vector3 p = axis.unitOrthogonal(), q = axis.cross(p);
  for (const double slant : {0.0, 1e-12}) {  // a cylinder, a cone
    Directions sides;
    constexpr int kSides = 100000;
    for (int i = 0; i < kSides; ++i) {
      const double angle = std::numbers::pi * i / kSides;
      sides.push_back(std::cos(angle) * p + std::sin(angle) * q + slant * axis);
    }
    const AreaVectors area = make_vectors(sides);
    const DirectionTree tree(area);
    const FlatSum flat(area);
    Directions u = gaussian(40, 11);
    for (std::size_t k = 0; k < u.size(); k += 3) u[k] = axis;
    const auto h = values(tree, u);
    const auto g = cuts(tree, u);
    std::vector<double> flat_values(u.size());
    Directions flat_cuts(u.size());
    flat.values(u, flat_values);
    flat.cuts(u, flat_cuts);
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double exact = exact_value(sides, u[k]);
      const double bound = DirectionTree::kErrorBound * area.total * u[k].norm();
      CHECK(std::abs(h[k] - exact) <= bound);
      CHECK(std::abs(g[k].dot(u[k]) - exact) <= bound);
      if (k % 3 != 0) continue;
      CHECK(h[k] == flat_values[k]);
      CHECK(g[k] == flat_cuts[k]);
      CHECK(values(tree, {u[k]})[0] == h[k]);  // whatever else is in the call
    }
  }
}

TEST_CASE("tree and vectors take at most two and a half times the vectors", "[direction_tree]") {
  const AreaVectors area = make_vectors(gaussian(100000, 10));
  CHECK(static_cast<double>(DirectionTree(area).bytes()) <= 1.5 * 24 * static_cast<double>(area.size()));
}

TEST_CASE("the objective's tree and flat sum agree, each in any batch", "[direction_tree][projected_area]") {
  const AreaVectors vectors = make_vectors(ellipsoid(24));
  Random random(12);
  std::vector<Rotation> rotations(40);
  for (Rotation& rotation : rotations) rotation = random_rotation(random);
  const auto all = [&](SumMethod evaluation) {
    const ProjectedArea objective(vectors, "mesh", evaluation);
    std::vector<double> values(rotations.size());
    objective.values(rotations, values);
    for (std::size_t i = 0; i < rotations.size(); i += 7) {
      double one = 0;
      objective.values({&rotations[i], 1}, {&one, 1});
      CHECK(one == values[i]);
    }
    return values;
  };
  const auto tree = all(SumMethod::kTree), flat = all(SumMethod::kFlat);
  // Three sums, each with an error of kErrorBound S at most, from either side.
  for (std::size_t i = 0; i < tree.size(); ++i) CHECK(std::abs(tree[i] - flat[i]) <= 6 * DirectionTree::kErrorBound);
  CHECK(all(SumMethod::kAuto) == (DirectionTree::worthwhile(vectors.size()) ? tree : flat));
}
