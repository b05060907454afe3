#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/render/rasterizer.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::render;

namespace {

const Ball kUnit = {Vector3::Zero(), 1};

/// Corners on the grid of 1/256 of a pixel of a picture of `size`, with any depths: nothing is rounded.
Mesh random_soup(std::size_t triangles, int size, double extent, Random random) {
  Mesh mesh;
  const double unit = 1.0 / (128 * size);
  const auto coordinate = [&](double centre, double reach) {
    return std::round(std::clamp(centre + reach * (2 * random.uniform() - 1), -1.0, 1.0) / unit) * unit;
  };
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const double x = 2 * random.uniform() - 1, y = 2 * random.uniform() - 1;
    for (int k = 0; k < 3; ++k)
      mesh.vertices.emplace_back(coordinate(x, extent), coordinate(y, extent), random.uniform() - 0.5);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

double cross(const Vector3& a, const Vector3& b, double x, double y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

/// The definition, pixel by pixel: exact, because corners and centres are small multiples of a power of two.
bool covers(const Mesh& mesh, const Triangle& t, double x, double y) {
  const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double area = cross(a, b, c.x(), c.y());
  if (area == 0) return false;
  const auto inside = [&](double side) { return side == 0 || (side > 0) == (area > 0); };
  return inside(cross(a, b, x, y)) && inside(cross(b, c, x, y)) && inside(cross(c, a, x, y));
}

/// Whether the triangle meets the closed square, by clipping the triangle at the square's four sides.
bool touches(const Mesh& mesh, const Triangle& t, double x, double y, double half) {
  std::vector<Eigen::Vector2d> polygon;
  for (const auto i : t) polygon.push_back(mesh.vertices[i].head<2>());
  for (int axis = 0; axis < 2; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const double limit = sign * (axis == 0 ? x : y) + half;
      std::vector<Eigen::Vector2d> kept;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = limit - sign * p[axis], dq = limit - sign * q[axis];
        if (dp >= 0) kept.push_back(p);
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + (q - p) * (dp / (dp - dq)));
      }
      polygon = kept;
    }
  return !polygon.empty();
}

DepthImage seen(const Mesh& mesh, const RenderOptions& options, const Rotation& frame = {}) {
  return ViewRenderer(mesh, kUnit, options).render(frame);
}

}  // namespace

TEST_CASE("A pixel is covered if its centre is in a closed triangle", "[rasterizer]") {
  const int size = GENERATE(1, 8, 32);
  const double extent = GENERATE(0.05, 0.3, 2.0);
  const Mesh mesh = random_soup(40, size, extent, Random(7));
  const DepthImage image = seen(mesh, {.size = size});
  int wrong = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = (2 * column + 1.0) / size - 1, y = 1 - (2 * row + 1.0) / size;
      double nearest = -2, low = 0, high = 0;
      for (const Triangle& t : mesh.triangles) {
        if (!covers(mesh, t, x, y)) continue;
        const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const double area = cross(a, b, c.x(), c.y());
        const double z = (cross(b, c, x, y) * a.z() + cross(c, a, x, y) * b.z() + cross(a, b, x, y) * c.z()) / area;
        if (z > nearest) nearest = z, low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
      }
      if (image.covered(column, row) != (nearest > -2)) ++wrong;
      if (nearest > -2) {
        CHECK(std::abs(image.at(column, row) - (32768 + 32767 * nearest)) < 0.51 + 0.05 * (high - low));
      }
    }
  CHECK(wrong == 0);
}

TEST_CASE("Touched: the pixels whose squares a triangle meets, edge on or not", "[rasterizer]") {
  const double extent = GENERATE(0.01, 0.1, 2.0);
  const int size = 16;
  Mesh mesh = random_soup(6, size, extent, Random(11));
  const int flat = GENERATE(0, 1, 2);
  if (flat == 1)
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh.vertices[3 * i + 2] = mesh.vertices[3 * i];
  if (flat == 2)
    for (Triangle& t : mesh.triangles) t = {t[0], t[0], t[0]};
  const DepthImage image = seen(mesh, {.size = size, .coverage = Coverage::kTouched});
  int wrong = 0, covered = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = (2 * column + 1.0) / size - 1, y = 1 - (2 * row + 1.0) / size;
      const bool met =
          std::ranges::any_of(mesh.triangles, [&](const Triangle& t) { return touches(mesh, t, x, y, 1.0 / size); });
      wrong += image.covered(column, row) != met;
      covered += met;
    }
  CHECK(wrong == 0);
  CHECK(covered > 0);
}

TEST_CASE("The picture from behind is the mirrored one, bit for bit", "[rasterizer]") {
  const Mesh mesh = make_shape(Spec::parse("blob?seed=3"));
  const Ball ball = ball_around(mesh);
  for (const Coverage coverage : {Coverage::kCentre, Coverage::kTouched})
    for (const int size : {64, 255}) {
      ViewRenderer renderer(mesh, ball, {.size = size, .coverage = coverage});
      const ViewSphere sphere(1);
      for (std::size_t k = 0; k < sphere.size(); ++k) {
        const auto [front, back] = renderer.render_both(frame_towards(sphere.directions()[k]));
        CHECK(front.depth == renderer.render(frame_towards(sphere.directions()[k])).depth);
        CHECK(back.depth == renderer.render(frame_towards(-sphere.directions()[k])).depth);
        bool mirrored = true;
        for (int y = 0; y < size; ++y)
          for (int x = 0; x < size; ++x) mirrored &= front.covered(x, y) == back.covered(size - 1 - x, y);
        CHECK(mirrored);
      }
    }
}

TEST_CASE("Known silhouettes and depths", "[rasterizer]") {
  // The middle half of the picture, its sides on borders of pixels.
  const Mesh box = make_shape(Spec::parse("box"));
  const Ball ball = {Vector3::Zero(), largest_extent(box)};
  const auto image = ViewRenderer(box, ball, {.size = 64}).render(frame_towards({0, 0, 1}));
  CHECK(image.covered_pixels() == 32 * 32);
  CHECK(image.at(32, 32) == 32768 + 16384);
  CHECK(image.at(15, 32) == 0);
  CHECK(image.at(16, 16) != 0);

  const Mesh sphere = make_shape(Spec::parse("sphere?subdivisions=6"));
  const auto disc = ViewRenderer(sphere, ball_around(sphere), {.size = 512}).render(frame_towards({1, 2, 3}));
  CHECK(static_cast<double>(disc.covered_pixels()) == Approx(3.14159265 * 256 * 256).epsilon(2e-3));
  CHECK(disc.at(256, 256) > 65500);
  CHECK(disc.at(256 + 181, 256) == Approx(32768 + 32767 * std::sqrt(0.5)).epsilon(3e-3));
}

TEST_CASE("A part thinner than a pixel is lost by centres, kept if touched", "[rasterizer]") {
  Mesh rod{{{-1, 0.001, 0}, {1, 0.001, 0}, {1, 0.002, 0}, {-1, 0.002, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  CHECK(seen(rod, {.size = 32}).covered_pixels() == 0);
  CHECK(seen(rod, {.size = 32, .coverage = Coverage::kTouched}).covered_pixels() == 32);
}

TEST_CASE("Order of triangles, threads and scale leave every bit", "[rasterizer]") {
  Mesh mesh = make_shape(Spec::parse("blob?seed=5&rotate=random"));
  const ViewSphere sphere(1);
  const auto pictures = [&](const Mesh& m, int threads) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    std::vector<std::vector<std::uint16_t>> depths;
    for (DepthImage& image : render_views(m, ball_around(m), sphere, {.size = 96}))
      depths.push_back(std::move(image.depth));
    return depths;
  };
  const auto expected = pictures(mesh, 1);
  CHECK(std::set(expected.begin(), expected.end()).size() == sphere.size());
  CHECK(pictures(mesh, 4) == expected);
  Mesh other = mesh;
  std::reverse(other.triangles.begin(), other.triangles.end());
  CHECK(pictures(other, 2) == expected);
  for (const int exponent : {-1000, -300, 400, 1020}) {
    other = mesh;
    for (Vector3& p : other.vertices)
      p = Vector3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
    CHECK(pictures(other, 2) == expected);
  }
}

TEST_CASE("What the cube's rotations permute is seen in the pictures", "[rasterizer]") {
  // The counts of covered pixels know nothing of the roll by quarter turns, nor of mirroring.
  Mesh mesh = make_shape(Spec::parse("blob?seed=9"));
  for (Vector3& p : mesh.vertices) p = Vector3(p.x(), 2 * p.y(), 3 * p.z() + 0.3 * p.x() * p.y());
  const Ball ball = ball_around(mesh);
  const ViewSphere sphere(0);
  const auto counts = [&](const Rotation& pose) {
    std::vector<std::size_t> n;
    for (const DepthImage& image : render_views(mesh, ball, sphere, {.size = 200}, pose))
      n.push_back(image.covered_pixels());
    return n;
  };
  const auto plain = counts({});
  for (std::size_t i = 0; i < 24; ++i) {
    const auto turned = counts(frame_symmetries()[i]);
    for (std::size_t k = 0; k < 6; ++k) CHECK(turned[k] == plain[sphere.permutations()[i][k]]);
  }
}

TEST_CASE("Soups that are hard to draw are drawn", "[rasterizer]") {
  const Mesh none;
  CHECK(seen(none, {}).covered_pixels() == 0);
  CHECK(ball_around(none).radius == 0);
  const Mesh point{{{1e300, -1e300, 5}}, {{0, 0, 0}}};
  const Ball at = ball_around(point);
  CHECK(at.radius == 0);
  CHECK(ViewRenderer(point, at, {.coverage = Coverage::kTouched}).render({}).covered_pixels() == 4);
  CHECK(ViewRenderer(point, at, {}).render({}).covered_pixels() == 0);
  const Mesh huge{{{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, 0}}, {{0, 1, 2}}};
  CHECK(ViewRenderer(huge, ball_around(huge), {}).render({}).covered_pixels() > 10000);
  const Mesh near{{{-10, -10, 3}, {10, -10, 3}, {0, 10, 3}}, {{0, 1, 2}}};  // all of the picture, in front of its ball
  const DepthImage full = seen(near, {.size = 100});
  CHECK(full.covered_pixels() == 10000);
  CHECK(full.at(50, 50) == 65535);
  const Mesh far{{{0, 0, 0}, {1e3, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK_THROWS_AS(seen(far, {}), std::invalid_argument);
  CHECK_THROWS_AS(seen(near, {.size = 0}), std::invalid_argument);
  CHECK_THROWS_AS(seen(near, {.size = 1 << 20}), std::invalid_argument);
  CHECK_THROWS_AS(ViewRenderer(near, {Vector3::Zero(), NAN}), std::invalid_argument);
}
