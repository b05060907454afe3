#include <Eigen/Geometry>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "io/bytes.h"
#include "io/triangulate.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/mesh_io.h"

namespace rectilin {
namespace {

// Shortest form that reads back as the same number.
template <class Number>
void append_number(std::string& out, Number value) {
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof(digits), value);
  out.append(digits, result.ptr);
}

// A prefix, three numbers, an end of line.
template <class Triple>
void append_line(std::string& out, std::string_view prefix, const Triple& triple) {
  out += prefix;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) out += ' ';
    append_number(out, triple[i]);
  }
  out += '\n';
}

std::array<std::uint64_t, 3> counted_from_one(const Triangle& triangle) {
  return {triangle[0] + std::uint64_t{1}, triangle[1] + std::uint64_t{1}, triangle[2] + std::uint64_t{1}};
}

Vector3 unit_normal(const Mesh& mesh, const Triangle& triangle) {
  const Vector3& a = mesh.vertices[triangle[0]];
  const Vector3& b = mesh.vertices[triangle[1]];
  const Vector3& c = mesh.vertices[triangle[2]];
  const Vector3 normal = (b - a).stableNormalized().cross((c - a).stableNormalized());
  return normal.allFinite() ? normal.stableNormalized() : Vector3::Zero();
}

std::string to_off(const Mesh& mesh) {
  std::string out =
      "OFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vector3& vertex : mesh.vertices) append_line(out, "", vertex);
  for (const Triangle& triangle : mesh.triangles) append_line(out, "3 ", triangle);
  return out;
}

std::string to_obj(const Mesh& mesh) {
  std::string out;
  for (const Vector3& vertex : mesh.vertices) append_line(out, "v ", vertex);
  for (const Triangle& triangle : mesh.triangles) {
    append_line(out, "f ", counted_from_one(triangle));
  }
  return out;
}

std::string to_ply(const Mesh& mesh, bool binary) {
  std::string out = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                    " 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  if (!binary) {
    for (const Vector3& vertex : mesh.vertices) append_line(out, "", vertex);
    for (const Triangle& triangle : mesh.triangles) append_line(out, "3 ", triangle);
    return out;
  }
  for (const Vector3& vertex : mesh.vertices) {
    for (const double coordinate : vertex) append_little_endian(out, coordinate);
  }
  for (const Triangle& triangle : mesh.triangles) {
    append_little_endian(out, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) append_little_endian(out, corner);
  }
  return out;
}

std::string to_stl_text(const Mesh& mesh) {
  std::string out = "solid\n";
  for (const Triangle& triangle : mesh.triangles) {
    append_line(out, "facet normal ", unit_normal(mesh, triangle));
    out += "outer loop\n";
    for (const std::uint32_t corner : triangle) append_line(out, "vertex ", mesh.vertices[corner]);
    out += "endloop\nendfacet\n";
  }
  return out += "endsolid\n";
}

void append_single(std::string& out, const Vector3& vector) {
  for (const double coordinate : vector) append_little_endian(out, static_cast<float>(coordinate));
}

std::string to_stl_binary(const Mesh& mesh, const std::string& name) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw MeshError(name + ": too many triangles for STL");
  }
  constexpr double kLargest = std::numeric_limits<float>::max();
  for (const Vector3& vertex : mesh.vertices) {
    if (vertex.cwiseAbs().maxCoeff() > kLargest) {
      throw MeshError(name + ": a coordinate is too large for the single precision of binary STL");
    }
  }
  std::string out(80, ' ');
  append_little_endian(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    append_single(out, unit_normal(mesh, triangle));
    for (const std::uint32_t corner : triangle) append_single(out, mesh.vertices[corner]);
    append_little_endian(out, std::uint16_t{0});
  }
  return out;
}

/// How much of the mesh's area the triangles' area vectors change, in all, when coordinates become single.
double single_precision_change(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  const double scale = unit_scale(box);
  const auto area_vector = [&](const Triangle& triangle, const auto& rounded) -> Vector3 {
    std::array<Vector3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) corners[i][k] = scale * rounded(mesh.vertices[triangle[i]][k]);
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  };
  const auto exact = [](double x) { return x; };
  // Through memory: GCC 12 takes the two conversions for none when it vectorises.
  const auto single = [](double x) {
    volatile float kept = static_cast<float>(x);
    return static_cast<double>(kept);
  };
  double area = 0, change = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const Vector3 before = area_vector(triangle, exact);
    area += before.norm();
    change += (area_vector(triangle, single) - before).norm();
  }
  return area > 0 ? change / area : 0;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

/// Refuses a mesh that single precision destroys; a line if it only changes it.
std::string check_single_precision(const Mesh& mesh, const std::string& name) {
  constexpr double kDestroyed = 1e-3, kChanged = 1e-5;
  const double change = single_precision_change(mesh);
  if (change > kDestroyed)
    throw MeshError(name + ": the single precision of binary STL would change the triangles by " + percent(change) +
                    " of the area: their coordinates are too large against the mesh, or too small; text STL or another "
                    "format keeps them, and --recentre helps a mesh that is far from the origin");
  if (change > kChanged)
    return name + ": the single precision of binary STL changes the triangles by " + percent(change) + " of the area";
  return "";
}

Mesh recentred(Mesh mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  const Vector3 centre = 0.5 * box.min() + 0.5 * box.max();
  for (Vector3& vertex : mesh.vertices) vertex -= centre;
  return mesh;
}

std::string to_bytes(const Mesh& mesh, MeshFormat format, bool binary, const std::string& name) {
  switch (format) {
    case MeshFormat::kOff:
      return to_off(mesh);
    case MeshFormat::kObj:
      return to_obj(mesh);
    case MeshFormat::kPly:
      return to_ply(mesh, binary);
    case MeshFormat::kStl:
      return binary ? to_stl_binary(mesh, name) : to_stl_text(mesh);
    case MeshFormat::kGltf:
    case MeshFormat::k3mf:
      break;
  }
  throw MeshError(name + ": this format is read, but not written");
}

struct Written {
  std::string bytes, note;
};

Written written(const Mesh& mesh, MeshFormat format, const WriteOptions& options, const std::string& name) {
  Written result{to_bytes(mesh, format, options.binary, name), ""};
  if (format == MeshFormat::kStl && options.binary) result.note = check_single_precision(mesh, name);
  return result;
}

Written moved_and_written(const Mesh& mesh, MeshFormat format, const WriteOptions& options, const std::string& name) {
  return options.recentre ? written(recentred(mesh), format, options, name) : written(mesh, format, options, name);
}

}  // namespace

std::string mesh_bytes(const Mesh& mesh, MeshFormat format, const WriteOptions& options, const std::string& name) {
  return moved_and_written(mesh, format, options, name).bytes;
}

std::string write_mesh(const std::filesystem::path& file, const Mesh& mesh, const WriteOptions& options) {
  const std::optional<MeshFormat> format = format_of_extension(file);
  if (!format) {
    throw MeshError(file.string() + ": the extension is none of .off, .obj, .ply, .stl");
  }
  const auto [bytes, note] = moved_and_written(mesh, *format, options, file.string());
  write_whole_file(file, bytes);
  return note;
}

}  // namespace rectilin
