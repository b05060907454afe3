// What every reader promises of a mesh, whatever the file.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "rectilin/mesh/mesh_io.h"
#include "rectilin/mesh/mesh_report.h"

namespace rectilin::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

inline void check(const LoadedMesh& loaded) {
  const auto& [mesh, report] = loaded;
  require(!mesh.triangles.empty());
  for (const Vector3& vertex : mesh.vertices) require(vertex.allFinite());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) require(corner < mesh.vertices.size());
  }
  require(report.degenerate < mesh.triangles.size());
  require(report.dropped_short + report.dropped_nonfinite + report.triangulated <= report.polygons);
  require(report.polygons - report.dropped_short - report.dropped_nonfinite <= mesh.triangles.size());
  require(mesh.vertices.size() + report.nonfinite_vertices <= report.vertices);
  require(report.unreferenced_vertices <= mesh.vertices.size());
  require(report.first_unknown.empty() == (report.unknown_statements == 0));
  require(report.left_over_place.empty() == (report.left_over_bytes == 0));
  require(summary(report).find('\n') == std::string::npos);
}

/// Runs a reader, which either throws MeshError with one line or keeps these promises.
template <class Read>
void check_reader(const Read& read) {
  try {
    check(read());
  } catch (const MeshError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

}  // namespace rectilin::fuzz
