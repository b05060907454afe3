// Silhouette areas against exact unions of polygons (the library Clipper, on a grid of whole numbers).
#include <clipper.hpp>

#include "rectilin/base/random.h"
#include "rectilin/render/silhouette_area.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::render;

namespace {

constexpr double kRange = 1 << 29;  // whole numbers; crossings are rounded to one, a relative 1e-9

Mesh soup(std::size_t triangles, double extent, bool meeting, Random& random) {
  Mesh mesh;
  const auto whole = [](double x) { return std::round(kRange * x); };
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Vector3 centre(random.uniform(), random.uniform(), 0);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vector3 p = centre + extent * Vector3(random.uniform() - 0.5, random.uniform() - 0.5, 0);
      mesh.vertices.emplace_back(whole(p.x()), whole(p.y()), whole(extent * random.uniform()));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    // A fan about an earlier corner, so that triangles share edges and corners.
    if (meeting && i > 0) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i - 3});
  }
  return mesh;
}

double union_area(const Mesh& mesh) {
  ClipperLib::Clipper clipper;
  for (const Triangle& t : mesh.triangles) {
    ClipperLib::Path path;
    for (const auto i : t)
      path.emplace_back(static_cast<ClipperLib::cInt>(mesh.vertices[i].x()),
                        static_cast<ClipperLib::cInt>(mesh.vertices[i].y()));
    if (ClipperLib::Area(path) < 0) ClipperLib::ReversePath(path);
    clipper.AddPath(path, ClipperLib::ptSubject, true);
  }
  ClipperLib::Paths paths;
  clipper.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  double area = 0;
  for (const ClipperLib::Path& path : paths) area += ClipperLib::Area(path);
  return area;
}

}  // namespace

TEST_CASE("Areas of random soups are those of their exact unions", "[silhouette]") {
  Random random(17);
  for (const std::size_t triangles : {1u, 2u, 5u, 20u, 100u, 400u})
    for (const double extent : {0.01, 0.1, 0.5, 1.5})
      for (const bool meeting : {false, true}) {
        const Mesh mesh = soup(triangles, extent, meeting, random);
        const double area = union_area(mesh);
        INFO(triangles << " triangles of extent " << extent << (meeting ? ", meeting" : ""));
        const AreaInterval exact = silhouette_area(mesh, {0, 0, 1}, 0);
        CHECK(exact.upper - exact.lower <= 1e-9 * exact.upper);
        CHECK(exact.lower <= area * (1 + 1e-6));
        CHECK(exact.upper >= area * (1 - 1e-6));
        for (const double tolerance : {0.1, 1e-3, 1e-6}) {
          const AreaInterval rough = silhouette_area(mesh, {0, 0, 1}, tolerance);
          CHECK(rough.upper - rough.lower <= tolerance * rough.upper * 1.0001);
          CHECK(rough.lower <= exact.upper);
          CHECK(rough.upper >= exact.lower);
        }
      }
}

TEST_CASE("Grids of coordinates make edges meet, overlap and coincide", "[silhouette]") {
  Random random(23);
  for (int run = 0; run < 300; ++run) {
    Mesh mesh;
    const int triangles = 1 + run % 40, side = 2 + run % 7;
    for (int i = 0; i < 3 * triangles; ++i)
      mesh.vertices.emplace_back(std::floor(random.uniform() * side) * (1 << 24),
                                 std::floor(random.uniform() * side) * (1 << 24), 0);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i)
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    const double area = union_area(mesh), unit = double{1 << 24} * (1 << 24);
    const AreaInterval exact = silhouette_area(mesh, {0, 0, 1}, 0);
    INFO(run);
    CHECK(exact.lower <= area + 1e-5 * unit);
    CHECK(exact.upper >= area - 1e-5 * unit);
    CHECK(exact.upper - exact.lower <= 1e-9 * unit);
  }
}
