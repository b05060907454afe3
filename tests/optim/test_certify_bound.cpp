// The certificate's lemmas under attack: random points where they claim a bound must not fall below it.
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "certify/bounder.h"
#include "certify/box_bound.h"
#include "certify/branch_and_bound.h"
#include "certify/kink_ball.h"
#include "certify/sieve.h"
#include "certify/support_floor.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;
using namespace rectilin::certification;

namespace {

#ifdef NDEBUG
constexpr int kEffort = 20;
#else
constexpr int kEffort = 1;
#endif

/// Vectors meant to be awkward: twelve orders of magnitude in area, nearly parallel pairs, exact multiples of the axes.
std::vector<Vector3> awkward_vectors(Random& random) {
  std::vector<Vector3> vectors;
  const int count = 3 + static_cast<int>(random.below(30));
  for (int i = 0; i < count; ++i) {
    const Vector3 v = test::random_vector(random) * std::pow(10.0, random.uniform(-12, 0));
    vectors.push_back(v);
    if (random.chance(0.3)) vectors.push_back(v + 1e-9 * v.norm() * test::random_vector(random));
    if (random.chance(0.3)) vectors.push_back(v.norm() * Vector3::Unit(static_cast<int>(random.below(3))));
  }
  return vectors;
}

Box random_box(Random& random) {
  Box box;
  const double size = std::pow(10.0, random.uniform(-9, 0));
  for (int i = 0; i < 3; ++i) {
    const double a = random.uniform(-kZoneHalfEdge, kZoneHalfEdge);
    const double b = std::clamp(a + size * random.uniform(), -kZoneHalfEdge, kZoneHalfEdge);
    box.lower[i] = std::min(a, b), box.upper[i] = std::max(a, b);
  }
  return box;
}

/// A point of the box, often on its boundary.
Eigen::Vector3d random_point(Random& random, const Box& box) {
  Eigen::Vector3d x;
  for (int i = 0; i < 3; ++i) {
    const double t = random.uniform();
    x[i] = t < 0.2 ? box.lower[i] : t > 0.8 ? box.upper[i] : random.uniform(box.lower[i], box.upper[i]);
  }
  return x;
}

double value_at(const ProjectedArea& objective, const Rotation& rotation) {
  double value;
  objective.values({&rotation, 1}, {&value, 1});
  return value;
}

}  // namespace

TEST_CASE("a linear form does not fall below its box bound", "[certify]") {
  Random random(1);
  double sharpest = 1;
  for (int trial = 0; trial < 5000 * kEffort; ++trial) {
    const Box box = random_box(random);
    Eigen::Matrix3d g;
    for (double& entry : g.reshaped()) entry = random.normal() * std::pow(10.0, random.uniform(-6, 0));
    const Corners corners(box);
    Array8 values = Array8::Zero();
    for (int k = 0; k < 3; ++k) values += corners.along(k, g.row(k));
    const double bound = box_bound(g, values, box), size = g.rowwise().norm().maxCoeff();
    for (int i = 0; i < 20; ++i) {
      const Rotation r = rotation_from_rodrigues(random_point(random, box));
      const double excess = g.cwiseProduct(r.matrix()).sum() - bound;
      REQUIRE(excess >= -kBoxRounding * size);
      sharpest = std::min(sharpest, excess / size);
    }
  }
  REQUIRE(sharpest < 1e-9);  // the attack comes as near as that, so the bound gives nothing away
}

TEST_CASE("the objective does not fall below a cell's bound", "[certify]") {
  Random random(2);
  int borrowed = 0, settled = 0;
  for (int trial = 0; trial < 400 * kEffort; ++trial) {
    const ProjectedArea objective(area_vectors(awkward_vectors(random)));
    const Box box = random_box(random);
    CutTable table;
    Cell cell;
    cell.box = box;
    for (int i = 0; i < 12; ++i) {
      // Cuts from the box, some at kinks, some from elsewhere. Only the first belong to the cell.
      const Rotation at = i % 4 < 3 ? rotation_from_rodrigues(random_point(random, box)) : random_rotation(random);
      Cut cut;
      objective.cuts({&at, 1}, {&cut, 1});
      for (int k = 0; k < 3 && i < 4; ++k) cell.bundles[k].add(table.size() + static_cast<std::uint32_t>(k), 6);
      table.add(at, cut);
    }
    // In half of the trials no bound is enough, in the others one that cuts from elsewhere in the table may reach.
    const double own = Bounder(table, 6).mix(cell, 10).value;
    const double enough = random.chance(0.5) ? 10 : own + std::pow(10.0, random.uniform(-12, -3));
    const PerCut<double> weight = Bounder(table, 6).raise(cell, enough);
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (int j = 0; j < cell.bundles[k].size; ++j) {
        REQUIRE(weight[k][j] >= 0);
        sum += weight[k][j];
        form.row(k) += weight[k][j] * table[cell.bundles[k].cuts[j]].transpose();
        if (weight[k][j] > 0) borrowed += cell.bundles[k].cuts[j] >= 12;
      }
      if (cell.bound >= enough) REQUIRE(sum == Approx(1).epsilon(1e-12));
    }
    settled += cell.bound >= enough;
    for (int i = 0; i < 200; ++i) {
      const Rotation r = rotation_from_rodrigues(random_point(random, box));
      REQUIRE(value_at(objective, r) >= cell.bound - 1e-13);
      if (cell.bound >= enough) REQUIRE(form.cwiseProduct(r.matrix()).sum() >= enough - 1e-13);
    }
  }
  CAPTURE(settled, borrowed);
  REQUIRE(settled > 5 * kEffort);
  REQUIRE(borrowed > 5 * kEffort);
}

TEST_CASE("what the sieve leaves out of a cell is not below what was asked for, the rest not below its bound",
          "[certify]") {
  Random random(7);
  int left_out = 0, kept = 0, empty = 0, below_mean = 0, above_mean = 0, as_greatest = 0, below_greatest = 0;
  double sharpest = 1, nearest = 1;
  const auto holds = [](const Box& box, const Eigen::Vector3d& p) {
    return ((box.lower.array() <= p.array()) && (p.array() <= box.upper.array())).all();
  };
  const std::vector<std::string> sets = instruction_sets();
  for (int trial = 0; trial < 400 * kEffort; ++trial) {
    const ScopedInstructionSet set(sets[static_cast<std::size_t>(trial / 3) % sets.size()]);
    const ProjectedArea objective(area_vectors(awkward_vectors(random)));
    Cell cell;
    cell.box = random_box(random);
    CutTable table;
    Balls balls;
    double least = 10;
    for (int i = 0; i < 12; ++i) {
      const Rotation at = rotation_from_rodrigues(random_point(random, cell.box));
      Cut cut;
      objective.cuts({&at, 1}, {&cut, 1});
      for (int k = 0; k < 3 && i < 3; ++k) cell.bundles[k].add(table.size() + static_cast<std::uint32_t>(k), 6);
      table.add(at, cut);
      least = std::min(least, cut.value);
    }
    const double enough = least * (1 - std::pow(10.0, random.uniform(-6, -0.5)));
    if (random.chance(0.3)) {
      const Rotation centre = rotation_from_rodrigues(random_point(random, cell.box));
      const double angle = kink_ball(objective.generators(), centre, enough);
      if (angle > 1e-6) balls.add(centre, angle);
    }
    const int axis = trial % 3;
    const Halves left = sift(cell, axis, table, balls, enough);
    for (int side = 0; side < 2; ++side) {
      const Box half = cell.box.half(axis, side);
      if (!left[side]) {
        ++empty;
        continue;
      }
      const Rest& rest = *left[side];
      REQUIRE((rest.box.lower.array() >= half.lower.array()).all());
      REQUIRE((rest.box.upper.array() <= half.upper.array()).all());
      REQUIRE(holds(rest.box, rest.low_point));
      const Rotation low = rotation_from_rodrigues(rest.low_point);
      REQUIRE(rest.value <= value_at(objective, low) + 1e-13);
      // The sieve may use the cell's own cuts, which it compares to first order in the angle.
      const double angle = angle_between(rotation_from_rodrigues(cell.box.centre()), low);
      double model = 0, allowed = 1e-13;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d first = table[cell.bundles[k].cuts[0]];
        double greatest = -10, farthest = 0;
        for (int j = 0; j < cell.bundles[k].size; ++j)
          greatest = std::max(greatest, table[cell.bundles[k].cuts[j]].dot(low.axis(k)));
        for (std::size_t j = 0; j < table.size(); ++j) farthest = std::max(farthest, (table[j] - first).norm());
        model += greatest;
        allowed += 4 * farthest * (angle * angle + 1e-4 * angle);
      }
      REQUIRE(rest.value >= model - allowed);
      ++(rest.value >= model - 1e-13 ? as_greatest : below_greatest);
      REQUIRE(rest.bound < enough);
    }
    const auto model = [&](const Eigen::Vector3d& p) {
      const Rotation r = rotation_from_rodrigues(p);
      double sum = 0;
      for (int k = 0; k < 3; ++k) {
        double greatest = -10;
        for (std::size_t j = 0; j < table.size(); ++j) greatest = std::max(greatest, table[j].dot(r.axis(k)));
        sum += greatest;
      }
      return sum;
    };
    for (const std::optional<Rest>& rest : left) {
      if (!rest) continue;
      double mean = 0;
      for (int i = 0; i < 20; ++i) mean += model(random_point(random, rest->box)) / 20;
      ++(rest->value < mean ? below_mean : above_mean);
    }
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d p = random_point(random, cell.box);
      if (p.lpNorm<1>() > 1) continue;
      const double value = value_at(objective, rotation_from_rodrigues(p));
      bool inside = false;
      for (const std::optional<Rest>& rest : left) {
        if (!rest || !holds(rest->box, p)) continue;
        inside = true;
        REQUIRE(value >= rest->bound - 1e-13);
        nearest = std::min(nearest, value - rest->bound);
      }
      if (inside) {
        ++kept;
        continue;
      }
      ++left_out;
      REQUIRE(value >= enough - 1e-13);
      sharpest = std::min(sharpest, value - enough);
    }
  }
  CAPTURE(left_out, kept, empty, sharpest, nearest, below_mean, above_mean, as_greatest, below_greatest);
  REQUIRE(left_out > 10'000 * kEffort);
  REQUIRE(kept > 1000 * kEffort);
  REQUIRE(empty > 10 * kEffort);
  REQUIRE(sharpest < 1e-4);  // the attack comes near
  REQUIRE(nearest < 1e-3);
  REQUIRE(as_greatest > 8 * below_greatest);  // 12.7 times
  REQUIRE(below_mean > 5 * above_mean);       // 14.6 times; 0.7 times if the highest middle were taken for the lowest
}

TEST_CASE("no rotation in a kink ball is below its value", "[certify]") {
  Random random(3);
  int balls = 0;
  for (int trial = 0; trial < 300 * kEffort; ++trial) {
    std::vector<Vector3> vectors = awkward_vectors(random);
    const Rotation frame = random_rotation(random);
    // Faces that contain axes of the frame, exactly but for rounding, or almost.
    for (int i = 0; i < 6; ++i) {
      const int k = i % 3;
      const Vector3 v = frame.axis((k + 1) % 3) * random.normal() + frame.axis((k + 2) % 3) * random.normal();
      const double off = random.chance(0.5) ? 0.0 : std::pow(10.0, random.uniform(-13, -4));
      vectors.push_back(v + off * frame.axis(k));
    }
    const ProjectedArea objective(area_vectors(vectors));
    const double value =
        value_at(objective, frame) - (random.chance(0.5) ? 1e-10 : std::pow(10.0, random.uniform(-9, -1)));
    const double angle = kink_ball(objective.generators(), frame, value);
    balls += angle > 0;
    for (int i = 0; i < 100 && angle > 0; ++i) {
      const double distance = random.chance(0.3) ? angle : angle * random.uniform();
      const Rotation r = rotation_from_vector(distance * test::random_vector(random).normalized()) * frame;
      REQUIRE(value_at(objective, r) >= value - 1e-11);
    }
  }
  REQUIRE(balls > 50 * kEffort);
}

TEST_CASE("values whose merit is within a gap lie between the cutoff and the threshold", "[certify]") {
  Random random(15);
  const ProjectedArea objective(area_vectors(awkward_vectors(random)));
  for (int trial = 0; trial < 100 * kEffort; ++trial) {
    const double value = random.uniform(1, 1.7), gap = std::pow(10.0, random.uniform(-9, 0));
    const auto within = [&](double x) { return std::abs(objective.merit(x) - objective.merit(value)) <= gap; };
    const double cutoff = cutoff_value(objective, value, gap), threshold = threshold_value(objective, value, gap);
    REQUIRE(within(cutoff * (1 + 1e-14)));
    REQUIRE_FALSE(within(cutoff * (1 - 1e-14)));
    REQUIRE(within(threshold * (1 - 1e-14)));
    REQUIRE_FALSE(within(threshold * (1 + 1e-14)));
  }
  REQUIRE(std::isinf(threshold_value(objective, 1.2, 10)));  // no merit is below -2
}

TEST_CASE("a box that a set of balls holds has every rotation in one", "[certify]") {
  Random random(4);
  int held = 0;
  for (int trial = 0; trial < 2000 * kEffort; ++trial) {
    Box box = random_box(random);
    const Rotation centre = rotation_from_rodrigues(random_point(random, box));
    const double angle = std::pow(10.0, random.uniform(-6, std::log10(1.5)));
    Balls balls;
    balls.add(frame_symmetries()[random.below(24)] * centre, angle);
    if (!balls.hold(box)) continue;
    ++held;
    for (int i = 0; i < 10; ++i)
      REQUIRE(frame_angle(rotation_from_rodrigues(random_point(random, box)), centre) <= angle * (1 + 1e-9));
  }
  REQUIRE(held > 100 * kEffort);
}

TEST_CASE("no ball holds a point outside, however little", "[certify]") {
  Random random(14);
  for (int trial = 0; trial < 20000 * kEffort; ++trial) {
    const Rotation centre = rotation_from_rodrigues(random_point(random, random_box(random)));
    const double angle = std::pow(10.0, random.uniform(-6, -1));
    const double beyond = angle * (1 + std::pow(10.0, random.uniform(-8, -3)));
    const Eigen::Quaterniond q =
        (rotation_from_vector(beyond * test::random_vector(random).normalized()) * centre).quaternion();
    const Vector3 point = q.vec() / q.w();
    Balls balls;
    balls.add(centre, angle);
    REQUIRE_FALSE(balls.hold({point, point}));
  }
}

TEST_CASE("triangles cover the sphere, and linear functions less quadratic ones have bounds on them", "[certify]") {
  Random random(5);
  int known = 0;
  for (int trial = 0; trial < 500 * kEffort; ++trial) {
    const Vector3 u = test::random_vector(random).normalized(), a = test::random_vector(random);
    Eigen::Matrix3d form;
    for (double& entry : form.reshaped()) entry = 0.1 * random.normal();
    form = (0.5 * (form + form.transpose())).eval();
    // Follows u down the subdivision: at every level a triangle or its mirror image holds it, but for rounding.
    std::vector<Triangle3> open;
    for (const Triangle3& octant : upper_octants()) open.push_back(octant);
    for (int level = 0; level < 12; ++level) {
      std::vector<Triangle3> holding;
      for (const Triangle3& p : open)
        for (const double mirror : {1.0, -1.0}) {
          Eigen::Matrix3d corners;
          for (int j = 0; j < 3; ++j) corners.col(j) = mirror * p[j];
          if ((corners.inverse() * u).minCoeff() < -1e-12) continue;
          holding.push_back(p);
          if (level < 2) continue;
          const Vector3 x = mirror * u;
          REQUIRE(a.dot(x) - x.dot(form * x) >= least_on(p, a, form) - 1e-12);
          known += least_on(p, a, form) > -10;
        }
      REQUIRE(!holding.empty());
      open.clear();
      for (const Triangle3& part : quarters(holding[0])) open.push_back(part);
    }
  }
  REQUIRE(known > 500 * kEffort);
}

TEST_CASE("an axis stays in its sweep", "[certify]") {
  Random random(6);
  int small = 0;
  for (int trial = 0; trial < 5000 * kEffort; ++trial) {
    const Box box = random_box(random);
    const Corners corners(box);
    const Rotation middle = rotation_from_rodrigues(box.centre());
    for (int k = 0; k < 3; ++k) {
      const Sweep sweep(box, corners, middle, k);
      if (!std::isfinite(sweep.radius())) continue;
      ++small;
      for (int i = 0; i < 10; ++i) {
        const Vector3 x = rotation_from_rodrigues(random_point(random, box)).axis(k);
        REQUIRE(sweep.holds(x));
        // A triangle with x in it, of any size, mirrored or not.
        const double size = std::pow(10.0, random.uniform(-9, -0.3)), mirror = random.chance(0.5) ? 1 : -1;
        const Vector3 a = x.cross(test::random_vector(random)).normalized(), b = x.cross(a);
        Triangle3 p;
        for (int j = 0; j < 3; ++j) {
          const double angle = 2 * std::numbers::pi / 3 * j;
          p[j] = mirror * (x + size * (std::cos(angle) * a + std::sin(angle) * b)).normalized();
        }
        REQUIRE(sweep.may_meet(sweep.place(p[0]), sweep.place(p[1]), sweep.place(p[2]), mirror));
      }
    }
  }
  REQUIRE(small > 5000 * kEffort);
}

TEST_CASE("sums over lists of generators are those over all of them", "[certify]") {
  Random random(7);
  for (int trial = 0; trial < 200 * kEffort; ++trial) {
    const ProjectedArea objective(area_vectors(awkward_vectors(random)));
    const GeneratorList all(objective.generators());
    // From the octants, whose corners many awkward vectors are orthogonal to, down to where few are left.
    Triangle3 p = upper_octants()[random.below(4)];
    GeneratorList above = all;
    Vector3 settled = Vector3::Zero();
    for (int level = 0; level < 12; ++level) {
      GeneratorList own;
      settled += above.split(p, own);
      REQUIRE(own.size() <= above.size());
      for (int i = 0; i < 5; ++i) {
        const Vector3 u = (random.uniform() * p[0] + random.uniform() * p[1] + random.uniform() * p[2]).normalized();
        const double h = all.cut(u).dot(u);
        REQUIRE((settled + own.cut(u)).dot(u) == Approx(h).margin(1e-13));
        REQUIRE((settled + own.compact().cut(u)).dot(u) == Approx(h).margin(1e-13));
      }
      above = own;
      p = quarters(p)[random.below(4)];
    }
  }
}

TEST_CASE("h does not fall below the floors of a sweep", "[certify]") {
  Random random(8);
  std::uint64_t proved = 0;
  double nearest = 1;  // by how much a value exceeds its floors, at least, in the surface's unit
  for (int trial = 0; trial < 20 * kEffort; ++trial) {
    // Half of them nearly round, as they are meant for.
    const ProjectedArea objective(
        trial % 2 == 0 ? area_vectors(awkward_vectors(random))
                       : area_vectors(load_mesh("shape:ellipsoid?a=1&b=1.1&c=1.15&faces=500&noise=0.01&seed=" +
                                                std::to_string(trial))
                                          .mesh));
    const Generators generators = objective.generators();
    const auto h = [&](const Vector3& u) {
      double sum = 0;
      for (std::size_t i = 0; i < generators.size(); ++i) sum += std::abs(u.dot(generators[i]));
      return sum;
    };
    SupportFloor floor(generators, 0, [] { return false; });
    for (int i = 0; i < 200; ++i) {
      if (i % 20 == 19) floor.update();
      Box box = random_box(random);  // of a size that floors are tried for
      box.upper = box.lower.array() + std::pow(10.0, random.uniform(-2.5, -0.5));
      const Corners corners(box);
      const Rotation middle = rotation_from_rodrigues(box.centre());
      const std::array<Sweep, 3> sweeps = {Sweep(box, corners, middle, 0), Sweep(box, corners, middle, 1),
                                           Sweep(box, corners, middle, 2)};
      const double asked = value_at(objective, rotation_from_rodrigues(random_point(random, box))) -
                           (random.chance(0.3) ? 0 : std::pow(10.0, random.uniform(-9, 0)));
      const auto floors = floor.prove(sweeps, asked);
      if (!floors) continue;
      ++proved;
      const Eigen::Matrix3d& form = floor.form();
      REQUIRE((*floors)[0] + (*floors)[1] + (*floors)[2] + form.trace() >= asked - 1e-15);
      for (int j = 0; j < 50; ++j) {
        const Rotation r = rotation_from_rodrigues(random_point(random, box));
        double value = 0;
        for (int k = 0; k < 3; ++k) {
          REQUIRE(h(r.axis(k)) - r.axis(k).dot(form * r.axis(k)) >= (*floors)[k]);
          value += h(r.axis(k));
        }
        nearest = std::min(nearest, value - (*floors)[0] - (*floors)[1] - (*floors)[2] - form.trace());
      }
    }
  }
  REQUIRE(proved > 200u * kEffort);
  REQUIRE(nearest < 1e-3);  // the attack comes as near as that
}

TEST_CASE("nothing is proved once a run is to stop", "[certify]") {
  const ProjectedArea objective(area_vectors(load_mesh("shape:sphere?subdivisions=2").mesh));
  const SupportFloor floor(objective.generators(), 0, [] { return true; });
  Box box = Box::zone();
  box.lower.setConstant(0.1), box.upper.setConstant(0.11);
  const Corners corners(box);
  const Rotation middle = rotation_from_rodrigues(box.centre());
  const Sweep x(box, corners, middle, 0), y(box, corners, middle, 1), z(box, corners, middle, 2);
  REQUIRE_FALSE(floor.prove({x, y, z}, 1.4));
  REQUIRE(SupportFloor(objective.generators(), 0, [] { return false; }).prove({x, y, z}, 1.4));
}
