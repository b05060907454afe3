// Fuzzes the mesh readers (libFuzzer). The first byte picks the format, the rest is the file. A
// reader either throws MeshError with one line, or keeps the promises of Mesh and MeshReport.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "rectilin/mesh/mesh_io.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const rectilin::LoadedMesh& loaded) {
  const auto& [mesh, report] = loaded;
  require(!mesh.triangles.empty());
  for (const rectilin::Vector3& vertex : mesh.vertices) require(vertex.allFinite());
  for (const rectilin::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) require(corner < mesh.vertices.size());
  }
  require(report.degenerate < mesh.triangles.size());
  require(report.dropped_short + report.dropped_nonfinite + report.triangulated <= report.polygons);
  require(report.polygons - report.dropped_short - report.dropped_nonfinite <= mesh.triangles.size());
  require(mesh.vertices.size() + report.nonfinite_vertices <= report.vertices);
  require(report.unreferenced_vertices <= mesh.vertices.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    check(rectilin::read_mesh(bytes, static_cast<rectilin::MeshFormat>(data[0] % 4), "fuzz"));
  } catch (const rectilin::MeshError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
