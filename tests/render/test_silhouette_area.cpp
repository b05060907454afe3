#include <tbb/global_control.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/silhouette_area.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::render;

namespace {

const Vector3 kDown = {0, 0, 1};

void check_holds(const AreaInterval& interval, double area, double relative = 1e-13) {
  INFO("[" << interval.lower << ", " << interval.upper << "] and " << area);
  CHECK(interval.lower <= area * (1 + relative));
  CHECK(interval.upper >= area * (1 - relative));
}

bool overlap(const AreaInterval& a, const AreaInterval& b) { return a.lower <= b.upper && b.lower <= a.upper; }

/// Half the summed areas of the projected triangles: the silhouette of a convex solid.
double half_projected(const Mesh& mesh, const Vector3& u) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& v = mesh.vertices;
    sum += std::abs((v[b] - v[a]).cross(v[c] - v[a]).dot(u.normalized())) / 4;
  }
  return sum;
}

void add_triangle(Mesh& mesh, const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({n, n + 1, n + 2});
}

void add_rectangle(Mesh& mesh, double x, double y, double width, double height, double z) {
  add_triangle(mesh, {x, y, z}, {x + width, y, z}, {x + width, y + height, z});
  add_triangle(mesh, {x, y, z}, {x, y + height, z}, {x + width, y + height, z});  // the other way round
}

}  // namespace

TEST_CASE("Of a convex solid the silhouette is half the projected area", "[silhouette]") {
  const std::string spec =
      GENERATE("box", "sphere?subdivisions=4", "ellipsoid", "cylinder?sides=64", "pyramid", "prism");
  const Mesh mesh = make_shape(Spec::parse(spec));
  const Silhouette silhouette(mesh);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vector3 u = random_rotation(random).axis(0);
    const AreaInterval exact = silhouette.area(u, 0), rough = silhouette.area(u, 1e-2);
    check_holds(exact, half_projected(mesh, u));
    CHECK(exact.upper - exact.lower <= 1e-9 * exact.upper);
    check_holds(rough, half_projected(mesh, u));
    CHECK(rough.upper - rough.lower <= 1.0001e-2 * rough.upper);
    CHECK(overlap(exact, silhouette.area(-u, 0)));
    CHECK(overlap(exact, silhouette.area(1e-300 * u, 0)));
  }
}

TEST_CASE("Along the axes too, where walls are seen edge on and edges lie on edges", "[silhouette]") {
  const Mesh stairs = make_shape(Spec::parse("stairs"));
  Vector3 lower = Vector3::Constant(1e9), upper = -lower;
  for (const Vector3& p : stairs.vertices) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  const Vector3 size = upper - lower;
  const Silhouette silhouette(stairs);
  double least = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const AreaInterval area = silhouette.area(Vector3::Unit(axis), 0);
    CHECK(area.upper - area.lower < 1e-10);
    const double box = size.prod() / size[axis];
    CHECK(area.upper < box * (1 + 1e-10));
    least = std::min(least, area.lower / box);
  }
  CHECK(least < 0.9);  // the steps themselves, from the side

  Mesh plates;  // many congruent rectangles over each other, cut in two in either way
  for (int i = 0; i < 300; ++i) add_rectangle(plates, 0.125, 0.25, 0.5, 0.25, 0.001 * i);
  check_holds(silhouette_area(plates, kDown, 0), 0.125);
  const AreaInterval edge_on = silhouette_area(plates, {0, 1, 0}, 1e-6);
  CHECK(edge_on.lower <= 0);
  CHECK(edge_on.upper < 1e-9);
}

TEST_CASE("Unions that are known", "[silhouette]") {
  Mesh mesh;
  add_rectangle(mesh, 0, 0, 4, 2, 0);
  add_rectangle(mesh, 1, 1, 2, 4, 7);
  check_holds(silhouette_area(mesh, kDown, 0), 8 + 8 - 2);
  Mesh apart = mesh;  // a second copy far away, in a place that numbers hold exactly
  for (const Vector3& p : mesh.vertices) apart.vertices.push_back(p + Vector3(1 << 20, 3 << 20, 0));
  for (const auto& [a, b, c] : mesh.triangles) apart.triangles.push_back({a + 12, b + 12, c + 12});
  const AreaInterval both = silhouette_area(apart, kDown, 1e-6);
  check_holds(both, 28);
  CHECK(both.upper - both.lower < 28e-6);

  Mesh star;  // two triangles that make a hexagram: the union has twelve sides
  const double r = std::sqrt(3.0);
  add_triangle(star, {0, 2, 0}, {-r, -1, 0}, {r, -1, 0});
  add_triangle(star, {0, -2, 1}, {-r, 1, 1}, {r, 1, 1});
  check_holds(silhouette_area(star, kDown, 0), 4 * r, 1e-12);

  Mesh ring;  // four rectangles around a hole
  add_rectangle(ring, 0, 0, 10, 1, 0);
  add_rectangle(ring, 0, 9, 10, 1, 0);
  add_rectangle(ring, 0, 0, 1, 10, 0);
  add_rectangle(ring, 9, 0, 1, 10, 0);
  check_holds(silhouette_area(ring, kDown, 0), 36);
}

TEST_CASE("Slivers and triangles without area", "[silhouette]") {
  Mesh slivers;
  for (int i = 0; i < 50; ++i) add_triangle(slivers, {0, i * 1.0, 0}, {1, i + 1e-9, 0}, {2, i * 1.0, 0});
  const AreaInterval thin = silhouette_area(slivers, kDown, 1e-6);
  check_holds(thin, 50e-9, 1e-6);
  CHECK(thin.upper < 51e-9);
  const Mesh line{{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}, {{0, 1, 2}, {0, 0, 1}, {1, 1, 1}}};
  const AreaInterval none = silhouette_area(line, kDown);
  CHECK(none.lower == 0);
  CHECK(none.upper < 1e-12);
  CHECK(silhouette_area(Mesh{}, kDown).upper == 0);
  const Mesh point{{{3, 4, 5}}, {{0, 0, 0}}};
  CHECK(silhouette_area(point, kDown).upper == 0);
  CHECK_THROWS_AS(silhouette_area(line, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(silhouette_area(line, {0, NAN, 0}), std::invalid_argument);
  CHECK_THROWS_AS(silhouette_area(line, kDown, -1), std::invalid_argument);
  CHECK_THROWS_AS(silhouette_area(line, kDown, NAN), std::invalid_argument);
}

TEST_CASE("Any scale: areas from the least numbers to the greatest", "[silhouette]") {
  const Mesh mesh = make_shape(Spec::parse("soup?faces=60"));
  const Vector3 u(1, 2, 3);
  const AreaInterval area = silhouette_area(mesh, u, 1e-6);
  for (const double scale : {1e120, 1e-120, 1e-150, 1e150}) {
    Mesh scaled = mesh;
    for (Vector3& p : scaled.vertices) p *= scale;
    const AreaInterval other = silhouette_area(scaled, u, 1e-6);
    CHECK(other.lower <= area.upper * scale * scale * (1 + 1e-12));
    CHECK(other.upper >= area.lower * scale * scale * (1 - 1e-12));
    CHECK(other.upper - other.lower <= 1.001e-6 * other.upper);
  }
  Mesh extreme = mesh;
  for (Vector3& p : extreme.vertices) p = p.normalized() * 1.7e308;
  const AreaInterval huge = silhouette_area(extreme, u);
  CHECK(std::isfinite(huge.lower));
  CHECK(huge.upper == std::numeric_limits<double>::infinity());
  for (Vector3& p : extreme.vertices) p = p * 1e-308 * 1e-308;
  const AreaInterval tiny = silhouette_area(extreme, u);
  CHECK(tiny.lower == 0);
  CHECK(tiny.upper > 0);
  CHECK(tiny.upper < 1e-300);
}

TEST_CASE("Only the set of points counts", "[silhouette]") {
  Mesh mesh = make_shape(Spec::parse("soup?faces=200&seed=4"));
  const Vector3 u(3, -1, 2);
  const AreaInterval area = silhouette_area(mesh, u, 1e-9);
  Mesh flipped = mesh;
  for (std::size_t i = 0; i < flipped.triangles.size(); i += 2)
    std::swap(flipped.triangles[i][0], flipped.triangles[i][1]);
  CHECK(overlap(area, silhouette_area(flipped, u, 1e-9)));
  Mesh doubled = mesh;
  doubled.triangles.insert(doubled.triangles.end(), flipped.triangles.begin(), flipped.triangles.end());
  CHECK(overlap(area, silhouette_area(doubled, u, 1e-9)));
  Mesh split;  // every triangle in four, by the middles of its sides, without common vertices
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vector3 &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
    const Vector3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    add_triangle(split, a, ab, ca), add_triangle(split, b, ab, bc), add_triangle(split, c, ca, bc);
    add_triangle(split, ab, bc, ca);
  }
  CHECK(overlap(area, silhouette_area(split, u, 1e-9)));
  Random random(5);
  for (int i = 0; i < 10; ++i) {
    const Rotation turn = random_rotation(random);
    Mesh turned = mesh;
    for (Vector3& p : turned.vertices) p = turn.matrix() * p;
    const AreaInterval other = silhouette_area(turned, turn.matrix() * u, 1e-9);
    CHECK(other.lower <= area.upper * (1 + 1e-12));
    CHECK(other.upper >= area.lower * (1 - 1e-12));
  }
}

TEST_CASE("Many directions: the same bits for any number of threads", "[silhouette]") {
  const Silhouette silhouette(make_shape(Spec::parse("blob?seed=2")));
  const ViewSphere sphere(1);
  std::vector<AreaInterval> single;
  for (const Vector3& d : sphere.directions()) single.push_back(silhouette.area(d, 1e-4));
  for (const std::size_t threads : {1u, 4u}) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto areas = silhouette.areas(sphere.directions(), 1e-4);
    for (std::size_t k = 0; k < sphere.size(); ++k) {
      CHECK(areas[k].lower == single[k].lower);
      CHECK(areas[k].upper == single[k].upper);
    }
  }
}

TEST_CASE("Pixels touched and pixels inside enclose the areas of real meshes", "[silhouette][data]") {
  const char* folder = std::getenv("RECTILIN_DATA");
  if (!folder) {
    WARN("RECTILIN_DATA is not set: no real meshes");
    return;
  }
  std::vector<std::string> files;
  for (const char* set : {"psb", "capod", "ikea", "classic"})
    for (const std::string& file : expand_folders({std::string(folder) + "/" + set})) files.push_back(file);
  const std::size_t step = std::max<std::size_t>(1, files.size() / 40);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < files.size(); i += step) {
    Mesh mesh;
    try {
      mesh = load_mesh(files[i]).mesh;
    } catch (const MeshError&) {
      continue;
    }
    INFO(files[i]);
    const Ball ball = ball_around(mesh);
    ViewRenderer touched(mesh, ball, {.size = 512, .coverage = Coverage::kTouched});
    ViewRenderer centres(mesh, ball, {.size = 2048});
    const Silhouette silhouette(mesh);
    for (const Vector3& u : {Vector3(1, 0, 0), Vector3(0.2, 0.5, -0.7)}) {
      const AreaInterval area = silhouette.area(u, 1e-6);
      CHECK(area.upper - area.lower <= 1.0001e-6 * area.upper + 1e-11 * ball.radius * ball.radius);
      const double unit = 2 * ball.radius;
      const double outside = static_cast<double>(touched.render(frame_towards(u)).covered_pixels()) / (512.0 * 512);
      CHECK(area.lower <= outside * unit * unit * (1 + 1e-6));
      const double about = static_cast<double>(centres.render(frame_towards(u)).covered_pixels()) / (2048.0 * 2048);
      CHECK(std::abs(area.lower / (unit * unit) - about) < 2e-3 * std::sqrt(about) + 1e-4);
      ++checked;
    }
  }
  CHECK(checked > 0);
}

TEST_CASE("Hostile soups: no NaN, no endless halving, and intervals that agree", "[silhouette]") {
  Random random(99);
  const double values[] = {0,      -0.0,  1,      -1,          0.5,         1e-300, -1e-300,
                           5e-324, 1e300, -1e300, 1 + 0x1p-52, 1 - 0x1p-53, 1e-8,   3};
  const auto pick = [&](std::size_t many) { return values[static_cast<std::size_t>(random.uniform() * double(many))]; };
  for (int run = 0; run < 400; ++run) {
    // Most runs keep to numbers of one size, so that something is left to see beside the largest.
    const std::size_t many = run % 4 == 0 ? 14 : run % 4 == 1 ? 8 : 5;
    Mesh mesh;
    for (int i = 0; i < 3 + run % 30; ++i) mesh.vertices.emplace_back(pick(many), pick(many), pick(many));
    for (int i = 0; i < 1 + run % 50; ++i) {
      const auto vertex = [&] { return static_cast<std::uint32_t>(random.uniform() * double(mesh.vertices.size())); };
      mesh.triangles.push_back({vertex(), vertex(), vertex()});
    }
    const Silhouette silhouette(mesh);
    for (const Vector3& u : {Vector3(0, 0, 1), Vector3(1, 1e-300, 0), Vector3(1, 1, 1), Vector3(1e-9, 1, 1e-10)}) {
      const AreaInterval exact = silhouette.area(u, 0), rough = silhouette.area(u, 0.1);
      CHECK(0 <= exact.lower);
      CHECK(exact.lower <= exact.upper);
      CHECK(std::isfinite(exact.lower));
      CHECK(overlap(exact, rough));
    }
    const Ball ball = ball_around(mesh);
    for (const Coverage coverage : {Coverage::kCentre, Coverage::kTouched})
      CHECK(ViewRenderer(mesh, ball, {.size = 16, .coverage = coverage}).render({}).depth.size() == 256);
  }
}

TEST_CASE("Many edges through one point, on one line, and around each other", "[silhouette]") {
  Mesh fan{{{0, 0, 0}}, {}};  // blades that do not share their sides
  Random random(8);
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const double a = 2e-3 * i, b = a + 1e-3;
    fan.vertices.insert(fan.vertices.end(), {{std::cos(a), std::sin(a), 0}, {std::cos(b), std::sin(b), 0}});
    fan.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  check_holds(silhouette_area(fan, kDown, 1e-6), 3000 * std::sin(1e-3) / 2, 1e-12);

  Mesh rings;  // square frames of one width, apart by the same
  for (int i = 1; i <= 200; ++i) {
    const double a = 2 * i, b = a + 1;
    for (const auto& [x, y, width, height] : {std::array{-b, -b, 2 * b, 1.0}, std::array{-b, a, 2 * b, 1.0},
                                              std::array{-b, -a, 1.0, 2 * a}, std::array{a, -a, 1.0, 2 * a}})
      add_rectangle(rings, x, y, width, height, 0);
  }
  double area = 0;
  for (int i = 1; i <= 200; ++i) area += 4 * ((2 * i + 1) * (2 * i + 1) - 4 * i * i);
  check_holds(silhouette_area(rings, kDown, 1e-6), area);

  Mesh lattice;  // bars across bars: 40,000 openings
  for (int i = 0; i < 200; ++i) {
    add_rectangle(lattice, i, 0, 0.5, 200, 0);
    add_rectangle(lattice, 0, i, 200, 0.5, 1);
  }
  check_holds(silhouette_area(lattice, kDown, 1e-6), 0.75 * 200 * 200);
}
