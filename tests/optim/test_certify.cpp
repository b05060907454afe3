// Certified optima of whole meshes.
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "certify/polish.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/run_record.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;

namespace {

AreaVectors shape(const std::string& spec) { return area_vectors(load_mesh("shape:" + spec).mesh); }

struct Certified {
  double lower, upper;  // of R
  CertifyResult result;
};

Certified certify_vectors(AreaVectors vectors, const CertifyOptions& options = {}, Budget budget = {}) {
  const ProjectedArea objective(std::move(vectors));
  Evaluator evaluator(objective, budget);
  Certified c;
  c.result = certify(evaluator, options);
  c.lower = objective.merit(c.result.incumbent.value);
  c.upper = objective.merit(c.result.lower);
  REQUIRE(c.result.lower <= c.result.incumbent.value);
  return c;
}

void require_encloses(const Certified& c, double exact, double gap) {
  REQUIRE(c.result.closed);
  REQUIRE(c.upper - c.lower <= gap * (1 + 1e-9));
  REQUIRE(c.lower <= exact + 1e-11);  // rounding of three sums
  REQUIRE(c.upper >= exact - 1e-11);
}

/// Side walls of an open prism over a regular n-gon. With an axis along the prism P is a planar problem, whose minimum
/// is at a wall: the walls' directions are i pi / n apart.
double aligned_prism(int n, double wall, double cap) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    sum += std::abs(std::cos(angle)) + std::abs(std::sin(angle));
  }
  const double surface = n * wall + 2 * cap;
  return 3 * surface / (wall * sum + 2 * cap) - 2;
}

}  // namespace

TEST_CASE("certify encloses known optima", "[certify]") {
  require_encloses(certify_vectors(shape("pyramid")), 3 * (1 + std::sqrt(5.0)) / 4 - 2, 1e-6);
  require_encloses(certify_vectors(shape("pyramid?rotate=random&scale=1e-60"), {.gap = 1e-9}),
                   3 * (1 + std::sqrt(5.0)) / 4 - 2, 1e-9);
  require_encloses(certify_vectors(shape("box?rotate=random")), 1, 1e-6);
  require_encloses(certify_vectors(shape("stairs?rotate=random")), 1, 1e-6);
}

TEST_CASE("a long regular prism stands upright at its optimum", "[certify]") {
  for (const int sides : {6, 8, 12}) {
    INFO(sides);
    const double radius = 0.5, height = 8;
    const double edge = 2 * radius * std::sin(std::numbers::pi / sides);
    const double cap = 0.5 * sides * radius * radius * std::sin(2 * std::numbers::pi / sides);
    const Certified c = certify_vectors(shape("prism?height=8&rotate=random&sides=" + std::to_string(sides)));
    require_encloses(c, aligned_prism(sides, edge * height, cap), 1e-6);
  }
}

TEST_CASE("certify accepts every degenerate mesh", "[certify]") {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY();
  for (const auto& vectors : {std::vector<Vector3>{x},
                              {x, -2 * x, 3 * x},
                              {x, y},
                              {x, x + y},
                              {x, 1e-12 * y},
                              {x, (x + 1e-9 * y).normalized()}})
    require_encloses(certify_vectors(area_vectors(vectors)), certify_vectors(area_vectors(vectors)).lower, 1e-6);
  require_encloses(certify_vectors(area_vectors({x})), 1, 1e-6);
  // Two unit vectors at 45 degrees: one lies along an axis, the other across two.
  require_encloses(certify_vectors(area_vectors({x, (x + y).normalized()})), 6 / (1 + std::sqrt(2.0)) - 2, 1e-6);
}

TEST_CASE("whatever stops certify, the interval holds", "[certify]") {
  const double best = certify_vectors(shape("soup?faces=60")).lower;
  for (const std::uint64_t evaluations : {1u, 2u, 3u, 50u, 201u, 1000u}) {
    const Certified c = certify_vectors(shape("soup?faces=60"), {}, {.evaluations = evaluations});
    if (evaluations >= Costs::kPerCut) REQUIRE(c.lower <= best + 1e-6);
    REQUIRE(c.upper >= best - 1e-11);
  }
  for (const int cells : {1, 10, 100, 1000}) {
    const Certified c = certify_vectors(shape("soup?faces=60"), {.cells = cells});
    REQUIRE(c.upper >= best - 1e-11);
    REQUIRE(c.result.cells <= static_cast<std::uint64_t>(cells) + 64);  // a round is finished
  }
  const Certified c = certify_vectors(shape("sphere"), {.seconds = 1e-3});
  REQUIRE(c.upper >= c.lower);
}

TEST_CASE("searches do not beat the certificate", "[certify]") {
  Random random(11);
  for (int trial = 0; trial < 12; ++trial) {
    const ProjectedArea objective(area_vectors(test::random_mesh(random, 4 << (trial / 2))));
    const RunRecord proof = run_optimizer(*make_optimizer(certify_method()), objective, {});
    REQUIRE(proof.outcome == RunRecord::Outcome::kFinished);
    Evaluator evaluator(objective);
    for (int start = 0; start < 50; ++start) {
      Rotation rotation = random_rotation(random);
      for (int k = 0; k < 9; ++k) evaluator.turn(rotation, k % 3);
    }
    REQUIRE(evaluator.incumbent().value >= *proof.value_bound);
    REQUIRE(evaluator.incumbent().value >= proof.incumbent.value - 1e-6);
  }
}

TEST_CASE("what a wide gap proves is not above the minimum", "[certify]") {
  Random random(12);
  int improvable = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const AreaVectors vectors = area_vectors(test::random_mesh(random, 4 << (trial % 6)));
    const double minimum = certify_vectors(vectors, {.gap = 1e-8}).result.incumbent.value;
    // The first rotation that is found may do, so the bound is all that the result says about better ones.
    const CertifyResult wide = certify_vectors(vectors, {.gap = 0.3, .descent = 0, .polish = false}).result;
    REQUIRE(wide.lower <= minimum + 1e-12);
    improvable += wide.incumbent.value > minimum + 1e-3;
  }
  REQUIRE(improvable > 100);
}

TEST_CASE("certify gives the same bits for any number of threads", "[certify]") {
  const ProjectedArea objective(shape("blob?faces=5000"));
  std::optional<RunRecord> first;
  for (const std::size_t threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const RunRecord record = run_optimizer(*make_optimizer(certify_method()), objective, {});
    if (!first) first = record;
    REQUIRE(record.digest == first->digest);
    REQUIRE(*record.value_bound == *first->value_bound);
    REQUIRE(record.incumbent.rotation.matrix() == first->incumbent.rotation.matrix());
    REQUIRE(record.costs.cuts == first->costs.cuts);
  }
}

TEST_CASE("nearly round meshes are enclosed, the same for any number of threads", "[certify]") {
  const Certified first = certify_vectors(shape("sphere?kind=even&faces=2000"));
  require_encloses(first, 0.5 * (first.lower + first.upper), 1e-6);
  REQUIRE(first.result.floor_triangles > 1000);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 8);
  const Certified again = certify_vectors(shape("sphere?kind=even&faces=2000"));
  REQUIRE(again.lower == first.lower);
  REQUIRE(again.upper == first.upper);
  REQUIRE(again.result.cells == first.result.cells);
  REQUIRE(again.result.floor_triangles == first.result.floor_triangles);
  // A rotated sphere has the same optimum.
  const Certified rotated = certify_vectors(shape("sphere?kind=even&faces=2000&rotate=random"));
  REQUIRE(rotated.lower <= first.upper + 1e-11);
  REQUIRE(first.lower <= rotated.upper + 1e-11);
  // Without floors it takes many more boxes.
  const Certified without = certify_vectors(shape("sphere?kind=even&faces=2000"), {.gap = 2e-5, .floors = false});
  REQUIRE(without.result.closed);
  REQUIRE(without.lower <= first.upper + 1e-11);
  REQUIRE(first.lower <= without.upper + 1e-11);
}

TEST_CASE("bounds agree with and without the helpers", "[certify]") {
  for (const char* spec : {"soup?faces=100", "sphere?kind=even&faces=300", "torus?rotate=random"}) {
    INFO(spec);
    const Certified with = certify_vectors(shape(spec), {.gap = 1e-5});
    const Certified without = certify_vectors(shape(spec), {.gap = 1e-5, .balls = false, .floors = false});
    REQUIRE(with.result.closed);
    REQUIRE(without.result.closed);
    REQUIRE(with.lower <= without.upper + 1e-11);
    REQUIRE(without.lower <= with.upper + 1e-11);
  }
}

TEST_CASE("certify tells where the pose is not unique", "[certify]") {
  const auto optima = [](const std::string& spec, double gap) {
    return certify_vectors(shape(spec), {.gap = gap, .optima = true}).result.optima;
  };
  const auto box = optima("box?rotate=random", 1e-6);
  REQUIRE(box.size() == 1);
  REQUIRE(box[0].kind == Optimum::Kind::kPoint);
  // A 12-sided prism repeats itself every 30 degrees, a frame about its axis every 90.
  const auto prism = optima("prism?height=8&sides=12&rotate=random", 1e-6);
  REQUIRE(prism.size() == 3);
  for (const Optimum& o : prism) REQUIRE(o.kind == Optimum::Kind::kPoint);
  const auto round = optima("cylinder?sides=2000", 1e-4);
  REQUIRE(std::ranges::any_of(round, [](const Optimum& o) { return o.kind == Optimum::Kind::kContinuum; }));
}

TEST_CASE("the list of optima holds every frame within a wide gap", "[certify]") {
  // A box turned by 0.03 about an edge is within the gap, further than 0.02 radians from the pose it is in, but in its
  // ball.
  const auto wide = certify_vectors(shape("box"), {.gap = 0.1, .optima = true}).result.optima;
  REQUIRE(wide.size() == 1);
  REQUIRE(wide[0].kind == Optimum::Kind::kPoint);
  // Where the budget ends before cells are small, nothing is called a continuum.
  for (const std::uint64_t evaluations : {110u, 150u, 200u, 300u}) {
    const auto cut_short =
        certify_vectors(shape("pyramid"), {.gap = 1e-6, .optima = true}, {.evaluations = evaluations});
    for (const Optimum& o : cut_short.result.optima) REQUIRE(o.kind != Optimum::Kind::kContinuum);
  }
}

TEST_CASE("polishing ends on faces parallel to at least two axes", "[certify]") {
  const ProjectedArea objective(shape("soup?faces=200"));
  Evaluator evaluator(objective);
  certify(evaluator, {.polish = false});
  certification::polish(evaluator);
  const Generators generators = objective.generators();
  std::array<int, 3> parallel = {};
  for (std::size_t i = 0; i < generators.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Vector3 v = generators[i];
      parallel[k] += std::abs(evaluator.incumbent().rotation.axis(k).dot(v)) <= 1e-12 * v.norm();
    }
  REQUIRE(parallel[0] + parallel[1] + parallel[2] == 3);
  REQUIRE(*std::ranges::max_element(parallel) < 3);
}
