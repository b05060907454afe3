// A check is worth something only if it fails on what is false: each is given a mesh, a convention
// or a search that is wrong, and one that is right.
#include <cmath>
#include <numbers>

#include "claims/definition.h"
#include "claims/inequalities.h"
#include "claims/lemma1.h"
#include "claims/paper_box.h"
#include "claims/range_of_r.h"
#include "claims/rectilinear.h"
#include "claims/robustness.h"
#include "claims/search_cost.h"
#include "claims/search_domain.h"
#include "rectilin/base/parameters.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::paper;
using namespace rectilin::paper::claims;

namespace {

constexpr double kRounding = 1e-11;

const TestMesh& pyramid() {
  static const TestMesh tested = make_test_mesh("shape:pyramid?rotate=random&seed=5");
  return tested;
}

const TestMesh& box() {
  static const TestMesh tested = make_test_mesh("shape:box?x=2&rotate=random&seed=6");
  return tested;
}

/// The tested as a search would see it that claims `ratio` for its optimum.
TestMesh with_search(TestMesh tested, double ratio) {
  tested.best.found = tested.best.lower = ratio;
  return tested;
}

TestMesh with_matrix(TestMesh tested, double scale) {
  tested.best.rotation = Rotation::from_matrix(scale * Eigen::Matrix3d::Identity());
  return tested;
}

/// The mesh of one shape with the objective of another.
TestMesh mixed(const TestMesh& mesh, const TestMesh& objective) {
  TestMesh tested = mesh;
  tested.objective = objective.objective;
  return tested;
}

Rotation inverse_convention(double a, double b, double c) { return rotation_from_euler(a, b, c).inverse(); }
Rotation reversed_convention(double a, double b, double c) { return rotation_from_euler(c, b, a); }

}  // namespace

TEST_CASE("the definition tells a wrong convention", "[claims]") {
  REQUIRE(check_convention(Random(1), rotation_from_euler).margin >= -1e-14);
  REQUIRE(check_convention(Random(1), inverse_convention).margin < -0.1);
  REQUIRE(check_convention(Random(1), reversed_convention).margin < -0.1);
  REQUIRE(check_definition(pyramid(), Random(1), rotation_from_euler).margin >= -kRounding);
  REQUIRE(check_definition(pyramid(), Random(1), inverse_convention).margin < -1e-3);
  REQUIRE(check_definition(mixed(pyramid(), box()), Random(1), rotation_from_euler).margin < -1e-3);
}

TEST_CASE("the definition allows for slivers and far-away meshes, no more", "[claims]") {
  Mesh far = load_mesh("shape:pyramid").mesh;
  for (Vector3& p : far.vertices) p += Vector3(1e6, -1e6, 1e6);
  REQUIRE(check_definition(make_test_mesh(far, "far"), Random(1), rotation_from_euler).margin >= -kRounding);
  REQUIRE(coordinate_rounding(*pyramid().mesh, pyramid().vectors().area()) < 1e-14);
}

TEST_CASE("checks do not depend on scale", "[claims]") {
  for (const char* scale : {"1e-100", "1", "1e100"}) {
    const TestMesh tested = make_test_mesh("shape:pyramid?rotate=random&seed=5&scale=" + std::string(scale));
    REQUIRE(check_definition(tested, Random(1), rotation_from_euler).margin >= -kRounding);
    REQUIRE(check_similarity(tested, Random(1)).margin >= -1e-9);
    REQUIRE(check_stability(tested, Random(1)).margin >= -1e-9);
    REQUIRE(check_positive(tested).margin == Approx(check_positive(pyramid()).margin).margin(kRounding));
  }
}

TEST_CASE("eq. (22) tells another mesh", "[claims]") {
  REQUIRE(check_angles(pyramid(), Random(2)).margin >= -kRounding);
  TestMesh wrong = pyramid();
  AreaVectors vectors = wrong.vectors();
  vectors.total *= 1.01;
  wrong.objective = std::make_shared<const ProjectedArea>(vectors);
  REQUIRE(check_mean(wrong).margin < -0.01);  // eq. (24): the mean is no longer 3/2
  REQUIRE(check_mean(pyramid()).margin > -1e-3);
}

TEST_CASE("inequalities fail where a map is no rotation", "[claims]") {
  REQUIRE(check_lower_per_face(pyramid(), Random(3)).margin == Approx(0).margin(1e-13));
  REQUIRE(check_upper_per_face(pyramid(), Random(3)).margin == Approx(0).margin(1e-13));
  REQUIRE(check_lower_per_face(with_matrix(pyramid(), 0.5), Random(3)).margin < -0.1);
  REQUIRE(check_upper_per_face(with_matrix(pyramid(), 2), Random(3)).margin < -0.1);
  REQUIRE(check_bounds_of_mesh(pyramid(), Random(3)).margin > 0.1);
  REQUIRE(check_bounds_of_mesh(with_search(pyramid(), 0.99), Random(3)).margin < -0.009);
}

TEST_CASE("Theorem 1 fails for a search that misses or invents an optimum", "[claims]") {
  REQUIRE(check_rectilinear_gives_equality(box()).margin == Approx(0).margin(1e-10));
  REQUIRE(check_equality_gives_rectilinear(box()).margin == Approx(0).margin(1e-10));
  REQUIRE(check_one_iff_rectilinear(box()).margin == Approx(0).margin(1e-9));
  REQUIRE(check_rectilinear_gives_equality(with_search(box(), 1.001)).margin < -0.0009);
  REQUIRE(check_one_iff_rectilinear(with_search(box(), 1.001)).margin < -0.0009);

  REQUIRE(check_equality_gives_rectilinear(pyramid()).margin > 0.01);
  REQUIRE(check_equality_gives_rectilinear(with_search(pyramid(), 1)).margin < -0.01);
  REQUIRE(check_one_iff_rectilinear(with_search(pyramid(), 1)).margin < -0.01);
}

TEST_CASE("a face's tilt bounds what it adds to P", "[claims]") {
  Random random(4);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3 n = random_rotation(random).axis(0);
    const double t = mean_tilt(area_vectors(std::vector<Vector3>{n}), Rotation()), excess = n.lpNorm<1>() - 1;
    REQUIRE(excess >= kLeastSlope * t - 1e-14);
    REQUIRE(excess <= std::sqrt(2.0) * t + 1e-14);
  }
}

TEST_CASE("the range of R fails for values outside", "[claims]") {
  REQUIRE(check_positive(pyramid()).margin == Approx(0.427).margin(1e-3));
  REQUIRE(check_positive(with_search(pyramid(), 1.6)).margin < 0);
  REQUIRE(check_range(with_search(pyramid(), 0.9)).margin < 0);
}

TEST_CASE("similarity fails for a search that depends on the pose", "[claims]") {
  REQUIRE(check_similarity(pyramid(), Random(5)).margin == Approx(0).margin(1e-9));
  REQUIRE(check_similarity(with_search(pyramid(), pyramid().best.found + 1e-5), Random(5)).margin < -1e-6);
}

TEST_CASE("spheres: the quadrature of the mean is good for every single face", "[claims]") {
  // The mean of |u . n| over the points is a sum over n alike: the worst face is the worst mesh.
  const std::vector<Vector3> directions = spread_directions(kDirections);
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 n = random_rotation(random).axis(0);
    double mean = 0;
    for (const Vector3& u : directions) mean += std::abs(u.dot(n)) / kDirections;
    REQUIRE(3 * mean == Approx(1.5).margin(5e-4));
  }
}

TEST_CASE("the second difference fails across a kink", "[claims]") {
  REQUIRE(check_not_constant(pyramid(), Random(7)).margin > 0.1);
  REQUIRE(check_second_difference(pyramid(), Random(7)).margin >= -2e-11);
  const Rotation frame = check_second_difference(pyramid(), Random(7)).rotation;
  REQUIRE(second_difference_error(*pyramid().objective, frame, 1.2) > 1e-3);
  // A single face seen along its normal: P does not change, which the paper excludes.
  const ProjectedArea flat(area_vectors(std::vector<Vector3>{Vector3::UnitZ()}));
  REQUIRE(std::isinf(second_difference_error(flat, Rotation(), 0.1)));
}

TEST_CASE("what the paper's box holds is what its domain reaches", "[claims]") {
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const Rotation r = random_rotation(random);
    const Rotation reached = paper_domain().rotation(paper_domain().coordinates(r));
    REQUIRE(in_paper_box(r) == (frame_angle(r, reached) < 1e-9));
  }
  REQUIRE(in_paper_box(Rotation()));
}

TEST_CASE("the optimum on the paper's box is enclosed", "[claims]") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const TestMesh tested = make_test_mesh("shape:prism?sides=5&height=0.8&rotate=random&seed=" + std::to_string(seed));
    const Enclosure on_box = enclose_on_paper_box(*tested.objective);
    REQUIRE(on_box.greatest_r() - on_box.least_r() < 1.1e-6);
    REQUIRE(in_paper_box(on_box.rotation));
    REQUIRE(tested.objective->value(on_box.rotation) == Approx(on_box.found).margin(1e-11));
    if (in_paper_box(tested.best.rotation)) REQUIRE(on_box.least_r() == Approx(tested.best.least_r()).margin(1e-5));
    // No node of a grid is better than the bound.
    std::vector<Rotation> grid;
    for (int i = 0; i <= 20 * 20 * 20; ++i)
      grid.push_back(paper_domain().from_unit(Vector3(i % 20, i / 20 % 20, i / 400) / 19.0));
    std::vector<double> values(grid.size());
    tested.objective->values(grid, values);
    for (const double value : values) REQUIRE(value >= on_box.lower);
  }
}

TEST_CASE("eq. (28) fails in poses the box does not reach, and only there", "[claims]") {
  REQUIRE(check_paper_box(make_test_mesh("shape:box")).margin == 0);
  // All axes as far from the octants of the box as they can be: a third of a half turn about (1,
  // -1, 1).
  const double a = -0.46364760900080604, b = 0.7297276562269662;
  const Mesh worst = load_mesh("shape:box?rotate=" + Json(a).dump() + "," + Json(b).dump() + "," + Json(a).dump()).mesh;
  REQUIRE(check_paper_box(make_test_mesh(worst, "worst")).margin == Approx(-0.5565).margin(1e-4));
  int lost = 0;
  for (std::uint64_t i = 0; i < 200; ++i) lost += check_paper_box_in_another_pose(box(), Random(i)).margin < -1e-6;
  REQUIRE(lost > 25);  // of 50 expected; four standard deviations
  REQUIRE(lost < 75);
}

TEST_CASE("a domain that does not cover is found out", "[claims]") {
  REQUIRE(check_chart(Random(9), covering_domain()).margin > -kRounding);
  REQUIRE(check_chart(Random(9), zone_domain()).margin > -kRounding);
  REQUIRE(check_chart(Random(9), paper_domain()).margin < -0.1);
  REQUIRE(check_domain_on_mesh(pyramid(), Random(9), zone_domain()).margin > -kRounding);
  REQUIRE(check_domain_on_mesh(pyramid(), Random(9), paper_domain()).margin < -1e-4);
}

TEST_CASE("gains after generation 150 are seen", "[claims]") {
  double largest = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const double gain = gain_after_150(*pyramid().objective, seed).r;
    REQUIRE(gain >= 0);
    largest = std::max(largest, gain);
  }
  REQUIRE(largest > 0);
}

TEST_CASE("the bound for changed area vectors holds and is not empty", "[claims]") {
  REQUIRE(r_change_bound(0) == 0);
  REQUIRE(r_change_bound(0.01) < 0.09);
  REQUIRE(std::isinf(r_change_bound(1)));
  REQUIRE(check_stability(pyramid(), Random(10)).margin >= -kRounding);
  REQUIRE(check_stability(with_search(pyramid(), 1.1), Random(10)).margin < -0.1);
}

TEST_CASE("the standard error of deletion is that of many deletions", "[claims]") {
  const TestMesh blob = make_test_mesh("shape:blob?faces=4000");
  constexpr int kSamples = 200;
  double sum = 0, squares = 0;
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const ProjectedArea rest(area_vectors(without_faces(*blob.mesh, 0.9, Random(i))));
    const double r = rectilinearity(rest.value(blob.best.rotation));
    sum += r;
    squares += r * r;
  }
  const double deviation = std::sqrt((squares - sum * sum / kSamples) / (kSamples - 1));
  // The sample deviation of 200 values is known to 5 %.
  REQUIRE(deviation == Approx(deletion_error(blob, 0.1)).epsilon(0.25));
}
