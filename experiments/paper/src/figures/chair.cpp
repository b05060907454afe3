#include "figures/chair.h"

#include <Eigen/Geometry>
#include <numbers>

#include "figures/sample.h"
#include "rectilin/mesh/shapes.h"

namespace rectilin::paper::figures {
namespace {

using Eigen::AngleAxisd;
using Eigen::Translation3d;

void add(Mesh& mesh, const Mesh& part, const Eigen::Isometry3d& place) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& p : part.vertices) mesh.vertices.push_back(place * p);
  for (const Triangle& t : part.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// A box about the origin of about `share` of all faces.
Mesh box(double x, double y, double z, double faces) {
  return make_shape(Spec::parse("box?x=" + number(x) + "&y=" + number(y) + "&z=" + number(z) +
                                "&faces=" + std::to_string(std::max(12, static_cast<int>(faces)))));
}

/// A round bar along z from the origin, of slender triangles.
Mesh bar(double radius, double length, double faces) {
  const int sides = std::max(8, static_cast<int>(faces / 4));
  return make_shape(Spec::parse("cylinder?radius=" + number(radius) + "&height=" + number(length) +
                                "&sides=" + std::to_string(sides)));
}

}  // namespace

Mesh chair(const ChairOptions& options) {
  const double faces = options.faces;
  Mesh mesh;
  const auto at = [](double x, double y, double z) { return Eigen::Isometry3d(Translation3d(x, y, z)); };
  add(mesh, box(0.5, 0.5, 0.05, 0.5 * faces), at(0, 0, 0.45));
  for (const double x : {-0.21, 0.21})
    for (const double y : {-0.21, 0.21}) add(mesh, bar(0.022, 0.43, 0.02 * faces), at(x, y, 0));
  if (options.stretchers) {
    const AngleAxisd along_x(std::numbers::pi / 2, Vector3::UnitY()), along_y(-std::numbers::pi / 2, Vector3::UnitX());
    for (const double side : {-0.21, 0.21}) {
      add(mesh, bar(0.012, 0.42, 0.01 * faces), at(-0.21, side, 0.18) * along_x);
      add(mesh, bar(0.012, 0.42, 0.01 * faces), at(side, -0.21, 0.14) * along_y);
    }
  }
  const Eigen::Isometry3d back = at(0, 0.23, 0.46) * AngleAxisd(-0.15, Vector3::UnitX());
  if (options.slats == 0) {
    add(mesh, box(0.5, 0.03, 0.5, 0.45 * faces), back * at(0, 0, 0.25));
    return mesh;
  }
  add(mesh, box(0.5, 0.03, 0.08, 0.1 * faces), back * at(0, 0, 0.46));
  const double pitch = 0.5 / options.slats;
  for (int i = 0; i < options.slats; ++i)
    add(mesh, box(0.6 * pitch, 0.03, 0.44, 0.3 * faces / options.slats), back * at((i + 0.5) * pitch - 0.25, 0, 0.22));
  return mesh;
}

}  // namespace rectilin::paper::figures
