#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/shapes.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;

namespace {

/// P(R)/S face by face from rotated vertices, as the paper defines it (eqs. 3-7, 10, 11).
double ratio_by_definition(const Mesh& mesh, const Rotation& rotation) {
  double projected = 0, surface = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = rotation.matrix() * mesh.vertices[t[0]], b = rotation.matrix() * mesh.vertices[t[1]],
                  c = rotation.matrix() * mesh.vertices[t[2]];
    const Vector3 eta = (b - a).cross(c - a);
    projected += 0.5 * eta.cwiseAbs().sum();
    surface += 0.5 * eta.norm();
  }
  return projected / surface;
}

double ratio(const Mesh& mesh, const Rotation& rotation) {
  const ProjectedArea objective(area_vectors(mesh));
  double value;
  objective.values({&rotation, 1}, {&value, 1});
  return value;
}

/// The tolerance of comparisons between sums in different orders and poses: rounding of some hundred terms.
constexpr double kRounding = 1e-12;

}  // namespace

TEST_CASE("P/S is the face-by-face definition (eqs. 3-7, 10, 11)", "[objective]") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Mesh mesh = test::random_mesh(random, 60);
    for (int j = 0; j < 20; ++j) {
      const Rotation r = random_rotation(random);
      REQUIRE(ratio(mesh, r) == Approx(ratio_by_definition(mesh, r)).epsilon(kRounding));
    }
  }
}

TEST_CASE("S <= P <= sqrt(3) S (eq. 12)", "[objective]") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const ProjectedArea objective(area_vectors(test::random_mesh(random, 1 + i % 7)));
    for (int j = 0; j < 100; ++j) {
      const Rotation r = random_rotation(random);
      double value;
      objective.values({&r, 1}, {&value, 1});
      REQUIRE(value >= 1 - kRounding);
      REQUIRE(value <= std::sqrt(3.0) + kRounding);
    }
  }
}

TEST_CASE("the mean of P/S over rotations is 3/2 (eq. 24)", "[objective]") {
  Random random(3);
  for (const char* shape : {"box", "pyramid", "soup", "cylinder"}) {
    INFO(shape);
    const ProjectedArea objective(area_vectors(make_shape(Spec::parse(shape))));
    const int n = 40000;
    std::vector<Rotation> rotations(n);
    for (Rotation& r : rotations) r = random_rotation(random);
    std::vector<double> values(n);
    objective.values(rotations, values);
    double mean = 0, square = 0;
    for (const double v : values) mean += v / n, square += v * v / n;
    const double deviation = std::sqrt(std::max(square - mean * mean, 0.0) / n);
    REQUIRE(mean == Approx(1.5).margin(5 * deviation + kRounding));
  }
}

TEST_CASE("rectilinear shapes measure 1 at their pose, whatever it is (Theorem 3.2)", "[objective]") {
  Random random(4);
  for (const char* shape : {"box", "lshape", "stairs", "stepped-pyramid"})
    for (int i = 0; i < 20; ++i) {
      const Rotation pose = random_rotation(random);
      const Mesh mesh = test::transformed(make_shape(Spec::parse(shape)),
                                          [&](const Vector3& v) -> Vector3 { return pose.inverse().matrix() * v; });
      REQUIRE(rectilinearity(ratio(mesh, pose)) == Approx(1).margin(1e-9));
      REQUIRE(rectilinearity(ratio(mesh, pose * rotation_from_vector({0.1, 0, 0}))) < 0.9);
    }
}

TEST_CASE("the square pyramid as high as its base at its best pose: 0.4270509831 (section 5.3)", "[objective]") {
  // Turned about its axis so that side faces are parallel to an axis of the frame: the known optimum.
  const Mesh pyramid = make_shape(Spec::parse("pyramid"));
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 1000; ++i)
    best = std::min(best, ratio(pyramid, rotation_from_vector({0, 0, i * std::numbers::pi / 2000})));
  REQUIRE(rectilinearity(best) == Approx(3 * ((1 + std::sqrt(5.0)) / 4) - 2).margin(1e-9));
}

TEST_CASE("R does not change under similarity, face order, splitting or flipping (Theorem 3.4)", "[objective]") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Mesh mesh = test::random_mesh(random, 40);
    const Rotation r = random_rotation(random), q = random_rotation(random);
    const double expected = ratio(mesh, r);
    const auto same = [&](const Mesh& other, const Rotation& at) {
      REQUIRE(ratio(other, at) == Approx(expected).epsilon(kRounding));
    };

    const Vector3 shift = test::random_vector(random);
    same(test::transformed(mesh, [&](const Vector3& v) -> Vector3 { return 3.7 * (q.matrix() * v) + shift; }),
         r * q.inverse());
    for (const double scale : {1e-120, 1e120})
      same(test::transformed(mesh, [&](const Vector3& v) -> Vector3 { return v * scale; }), r);

    Mesh shuffled = mesh;
    for (std::size_t n = shuffled.triangles.size(); n > 1; --n)
      std::swap(shuffled.triangles[n - 1], shuffled.triangles[random.below(n)]);
    same(shuffled, r);

    Mesh split = mesh;
    for (const Triangle& t : mesh.triangles) {  // each triangle into two, at a point of its edge; half of them flipped
      const double s = random.uniform();
      const auto middle = static_cast<std::uint32_t>(split.vertices.size());
      split.vertices.push_back(s * mesh.vertices[t[0]] + (1 - s) * mesh.vertices[t[1]]);
      split.triangles[&t - mesh.triangles.data()] = {t[0], middle, t[2]};
      split.triangles.push_back(random.chance(0.5) ? Triangle{middle, t[1], t[2]} : Triangle{t[2], t[1], middle});
    }
    same(split, r);
  }
}

TEST_CASE("P is the same for the frame's 24 symmetries", "[objective]") {
  Random random(6);
  const Mesh mesh = test::random_mesh(random, 40);
  const Rotation r = random_rotation(random);
  for (const Rotation& d : frame_symmetries()) REQUIRE(ratio(mesh, d * r) == Approx(ratio(mesh, r)).epsilon(kRounding));
}

TEST_CASE("cuts are minorants, tight where they were taken", "[objective]") {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const ProjectedArea objective(area_vectors(test::random_mesh(random, 50)));
    std::vector<Rotation> rotations(30);
    for (Rotation& r : rotations) r = random_rotation(random);
    std::vector<double> values(rotations.size());
    std::vector<Cut> cuts(rotations.size());
    objective.values(rotations, values);
    objective.cuts(rotations, cuts);
    for (std::size_t a = 0; a < rotations.size(); ++a) {
      REQUIRE(cuts[a].value == Approx(values[a]).epsilon(kRounding));
      for (std::size_t b = 0; b < rotations.size(); ++b) {
        const double linear = cuts[a].gradient.cwiseProduct(rotations[b].matrix()).sum();
        REQUIRE(linear <= values[b] + kRounding);
        if (a == b) REQUIRE(linear == Approx(values[a]).epsilon(kRounding));
      }
    }
  }
}

TEST_CASE("the cut's gradient is the derivative along turns of the frame", "[objective]") {
  Random random(8);
  const ProjectedArea objective(area_vectors(test::random_mesh(random, 50)));
  const auto value = [&](const Rotation& r) {
    double v;
    objective.values({&r, 1}, {&v, 1});
    return v;
  };
  for (int i = 0; i < 100; ++i) {
    const Rotation r = random_rotation(random);
    Cut cut;
    objective.cuts({&r, 1}, {&cut, 1});
    const Vector3 gradient = turning_gradient(cut.gradient, r);
    const double step = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Vector3 turn = Vector3::Unit(k) * step;
      const double slope =
          (value(rotation_from_vector(turn) * r) - value(rotation_from_vector(-turn) * r)) / (2 * step);
      // A kink between the two points would show as an error of the size of a face; none is met with this seed.
      REQUIRE(slope == Approx(gradient[k]).margin(1e-6));
    }
  }
}

TEST_CASE("values in a batch that shares axes are those asked for one by one", "[objective]") {
  const ProjectedArea objective(area_vectors(make_shape(Spec::parse("soup"))));
  std::vector<Rotation> rotations;
  for (int i = 0; i < 40; ++i) rotations.push_back(rotation_from_euler(0.3 + i / 10, 0.2, 0.01 * i));
  std::vector<double> batch(rotations.size());
  objective.values(rotations, batch);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    double single;
    objective.values({&rotations[i], 1}, {&single, 1});
    REQUIRE(batch[i] == Approx(single).epsilon(kRounding));
  }
}

TEST_CASE("the best turn is the least over the circle", "[objective]") {
  Random random(9);
  for (int i = 0; i < 30; ++i) {
    const ProjectedArea objective(area_vectors(test::random_mesh(random, 3 + i)));
    const Rotation start = random_rotation(random);
    for (int k = 0; k < 3; ++k) {
      const BestTurn best = objective.best_turn(start, k);
      REQUIRE((best.rotation.axis(k) - start.axis(k)).norm() < 1e-14);
      constexpr int samples = 2000;
      constexpr double step = std::numbers::pi / 2 / samples;
      std::vector<Rotation> circle;
      for (int j = 0; j < samples; ++j) circle.push_back(rotation_from_vector(Vector3::Unit(k) * (step * j)) * start);
      std::vector<double> values(circle.size());
      objective.values(circle, values);
      const double least = *std::ranges::min_element(values);
      REQUIRE(best.value <= least + kRounding);
      // Slopes are below 2: the circle's least sample is this close to its minimum.
      REQUIRE(best.value >= least - 2 * step);
      double again;
      objective.values({&best.rotation, 1}, {&again, 1});
      REQUIRE(best.value == again);
    }
  }
}

TEST_CASE("the best turn is the least over all kinks, for any number of directions and threads", "[objective]") {
  for (const char* shape : {"box?rotate=random", "stairs?steps=40&rotate=random", "filleted-cube?segments=6",
                            "filleted-cube?segments=6&rotate=random", "cylinder?sides=700",
                            "sphere?kind=latlong&slices=40&stacks=20", "blob?faces=3000"}) {
    INFO(shape);
    const ProjectedArea objective(area_vectors(make_shape(Spec::parse(shape))));
    Random random(11);
    for (int k = 0; k < 3; ++k) {
      // The identity, too: of unturned CAD-like meshes many kinks coincide, at the ends of the quarter circle.
      const Rotation start = k == 0 ? Rotation() : random_rotation(random);
      std::vector<Rotation> kinks;
      for (std::size_t i = 0; i < objective.vectors().size(); ++i) {
        // The turn that brings v into the plane of axis k and the next, so that the third is parallel to the face.
        const Vector3 v = start.matrix() * objective.vectors()[i];
        const double angle = -std::atan2(v[(k + 2) % 3], v[(k + 1) % 3]);
        kinks.push_back(rotation_from_vector(Vector3::Unit(k) * angle) * start);
      }
      std::vector<double> values(kinks.size());
      objective.values(kinks, values);
      const double least = *std::ranges::min_element(values);
      REQUIRE(objective.best_turn(start, k).value == Approx(least).epsilon(kRounding));
    }
  }
}

TEST_CASE("turns and smooth values are the same bits for any number of threads", "[objective]") {
  Random random(12);
  std::vector<Vector3> vectors(100'000);  // several tasks
  for (Vector3& v : vectors) v = test::random_vector(random);
  const ProjectedArea objective(area_vectors(std::move(vectors)));
  const Rotation at = random_rotation(random);
  const auto results = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] {
      const SmoothValue smooth = objective.smooth(at, 0.01);
      const BestTurn turn = objective.best_turn(at, 1);
      return std::tuple(smooth.value, smooth.gradient, turn.value, turn.rotation.matrix());
    });
  };
  const auto one = results(1);
  for (const int threads : {2, 8}) REQUIRE(results(threads) == one);
}

TEST_CASE("turns and smooth values agree on every instruction set", "[objective]") {
  Random random(13);
  const ProjectedArea objective(
      area_vectors(make_shape(Spec::parse("blob?faces=1003"))));  // no multiple of any register
  const Rotation at = random_rotation(random);
  const SmoothValue smooth = objective.smooth(at, 0.01);
  const double turned = objective.best_turn(at, 2).value;
  for (const std::string& name : instruction_sets()) {
    INFO(name);
    const ScopedInstructionSet target(name);
    REQUIRE(objective.best_turn(at, 2).value == Approx(turned).epsilon(kRounding));
    const SmoothValue other = objective.smooth(at, 0.01);
    REQUIRE(other.value == Approx(smooth.value).epsilon(kRounding));
    REQUIRE((other.gradient - smooth.gradient).norm() < kRounding);
  }
}

TEST_CASE("the smooth surrogate lies above, tends to P/S, and has the gradient it says", "[objective]") {
  Random random(10);
  const ProjectedArea objective(area_vectors(test::random_mesh(random, 50)));
  for (int i = 0; i < 30; ++i) {
    const Rotation r = random_rotation(random);
    double value;
    objective.values({&r, 1}, {&value, 1});
    double previous = std::numeric_limits<double>::infinity();
    for (const double width : {1.0, 0.1, 0.01, 1e-3, 1e-9}) {
      const SmoothValue smooth = objective.smooth(r, width);
      REQUIRE(smooth.value >= value - kRounding);
      REQUIRE(smooth.value <= value + 3 * width + kRounding);
      REQUIRE(smooth.value <= previous);
      previous = smooth.value;
    }
    const SmoothValue smooth = objective.smooth(r, 0.1);
    const Vector3 gradient = turning_gradient(smooth.gradient, r);
    for (int k = 0; k < 3; ++k) {
      const Vector3 turn = Vector3::Unit(k) * 1e-5;
      const double slope = (objective.smooth(rotation_from_vector(turn) * r, 0.1).value -
                            objective.smooth(rotation_from_vector(-turn) * r, 0.1).value) /
                           2e-5;
      REQUIRE(slope == Approx(gradient[k]).margin(1e-8));
    }
  }
}
