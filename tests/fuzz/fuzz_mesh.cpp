// Fuzzes the mesh readers (libFuzzer). The first byte picks the format, the rest is the file. A reader either throws
// MeshError with one line, or keeps the promises of Mesh and MeshReport; the mesh survives being written and read again
// in every format, with the same area and the same projected area at any rotation (so with the same R); and a file with
// something behind it is not read as if that were not there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check_mesh.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/mesh/mesh_report.h"

namespace {

using namespace rectilin;

using fuzz::check;
using fuzz::require;

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= 1e-12 * a; }

/// The area, and the projected area at some rotations; empty if the mesh cannot be measured.
std::vector<double> measured(const Mesh& mesh) try {
  const ProjectedArea objective(area_vectors(mesh), "mesh");
  const std::array rotations = {Rotation(), rotation_from_euler(0.3, 0.5, 1.1), rotation_from_euler(2, 0.1, 0.7)};
  std::vector<double> values(rotations.size() + 1, objective.vectors().area());
  objective.values(rotations, std::span(values).first(rotations.size()));
  return values;
} catch (const MeshError&) {
  return {};
}

/// Errors here are the writer's or the reader's: what was read must be readable.
void check_survives(const Mesh& mesh) try {
  const std::vector<double> before = measured(mesh);
  for (const MeshFormat format : {MeshFormat::kOff, MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kStl}) {
    for (const bool binary : {false, true}) {
      if (binary && format != MeshFormat::kPly) continue;  // binary STL may be refused, and is not exact
      const LoadedMesh back = read_mesh(mesh_bytes(mesh, format, {.binary = binary}, "written"), format, "written");
      require(summary(back.report).empty());
      require(back.mesh.triangles.size() == mesh.triangles.size());
      require(std::ranges::equal(before, measured(back.mesh), same));
    }
  }
  try {
    const std::string bytes = mesh_bytes(mesh, MeshFormat::kStl, {}, "written");
    require(read_mesh(bytes, MeshFormat::kStl, "written").mesh.triangles.size() == mesh.triangles.size());
  } catch (const MeshError&) {  // beyond single precision
  }
} catch (const MeshError&) {
  std::abort();
}

/// Reads a file; with something behind it, it must be refused, or there is more to report.
void check_end(std::string_view bytes, MeshFormat format) {
  const std::string longer = std::string(bytes) + "\n\n7 x\n";
  try {
    require(!summary(read_mesh(longer, format, "longer").report).empty());
  } catch (const MeshError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto format = static_cast<MeshFormat>(data[0] % 4);
  try {
    const LoadedMesh loaded = read_mesh(bytes, format, "fuzz");
    check(loaded);
    check_survives(loaded.mesh);
    check_end(bytes, format);
  } catch (const MeshError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
