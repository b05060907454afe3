// The readers on real files: every model of the data folder is read, or refused with one clear
// error.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rectilin/mesh/mesh_io.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

struct Outcome {
  std::size_t triangles = 0;
  MeshReport report;
  std::string error;
};

// All models below a folder of the data by relative path; empty, with a warning, if there is no
// data.
std::map<std::string, Outcome> read_all(const std::string& set) {
  std::map<std::string, Outcome> outcomes;
  const char* const data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) {
    WARN("RECTILIN_DATA is not set, so the models of " << set << " are not read");
    return outcomes;
  }
  const std::filesystem::path folder = std::filesystem::path(data) / set;
  const std::set<std::string> extensions = {".off", ".obj", ".ply", ".stl", ".OBJ", ".STL"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !extensions.count(entry.path().extension().string())) continue;
    Outcome& outcome = outcomes[entry.path().lexically_relative(folder).generic_string()];
    try {
      const LoadedMesh loaded = read_mesh(entry.path());
      outcome = {loaded.mesh.triangles.size(), loaded.report, ""};
    } catch (const MeshError& error) {
      const std::string text = error.what();
      const std::string place = entry.path().string() + ":";
      CHECK(text.substr(0, place.size()) == place);
      CHECK(text.find('\n') == std::string::npos);
      outcome.error = text.substr(place.size());
    }
  }
  return outcomes;
}

std::size_t count_refused(const std::map<std::string, Outcome>& outcomes) {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.second.error.empty(); }));
}

}  // namespace

TEST_CASE("Princeton Shape Benchmark: every model is read") {
  const auto outcomes = read_all("psb");
  if (outcomes.empty()) return;
  CHECK(outcomes.size() == 904 + 3);  // and three stand-ins
  for (const auto& [name, outcome] : outcomes) {
    INFO(name);
    CHECK(outcome.error == "");
    CHECK(outcome.report.nonfinite_vertices == 0);
    CHECK(outcome.report.polygons == outcome.triangles);
  }
}

TEST_CASE("IKEA furniture: every model is read") {
  const auto outcomes = read_all("ikea");
  if (outcomes.empty()) return;
  CHECK(outcomes.size() == 30);
  CHECK(count_refused(outcomes) == 0);
}

TEST_CASE("classic models: read with the known number of triangles, refused if there is no surface") {
  auto outcomes = read_all("classic");
  if (outcomes.empty()) return;
  const std::map<std::string, std::string> refused = {
      {"pmp-data/beetle.off", "line 1: OFF BINARY is not supported, only OFF as text"},
      {"pmp-data/fairing-cross.off", "line 1: OFF BINARY is not supported, only OFF as text"},
      {"vclib/bunny_edge_sections.obj", " no faces, so there is no surface to measure"},
      {"vclib/edge_mesh.obj", " no faces, so there is no surface to measure"},
      {"vclib/chameleon4k.ply", " no faces, so there is no surface to measure"}};
  for (const auto& [name, reason] : refused) CHECK(outcomes[name].error == reason);
  CHECK(count_refused(outcomes) == refused.size());
  CHECK(outcomes["common-3d-test-models/teapot.obj"].triangles == 6320);
  CHECK(outcomes["nwtnni-photon/dragon.obj"].triangles == 100000);
  CHECK(outcomes["nwtnni-photon/buddha.obj"].triangles == 100000);
  CHECK(outcomes["common-3d-test-models/igea.ply"].triangles == 268686);  // triangle strips
  CHECK(outcomes["libigl-tutorial-data/inspired_mesh_quads_Smooth.off"].triangles == 3676);
  CHECK(outcomes["cinolib/E.obj"].triangles == 10);  // one concave polygon
  CHECK(outcomes["vclib/bimba_bin.stl"].report.vertices == 3 * outcomes["vclib/bimba_bin.stl"].triangles);
}

TEST_CASE("malformed models: some are read after all, the others give one error with its place") {
  auto outcomes = read_all("malformed");
  if (outcomes.empty()) return;
  const std::map<std::string, std::string> refused = {
      {"assimp/invalid/OutOfMemory.off",
       "line 2: the header claims 353535235358 vertices and 6 faces, more than the file can hold"},
      {"assimp/invalid/empty.ply", " the file is empty"},
      {"assimp/invalid/malformed.obj", "line 28: vertex index 0, but the first vertex is 1"},
      {"assimp/OFF/invalid.off", "line 8: vertex index 20 is not in 0..2"},
      {"assimp/OBJ/number_formats.obj", "line 11: expected a coordinate, found '3.1+e2'"},
      {"tinyobjloader/invalid-relative-vertex-index.obj", "line 1: vertex index -4, but only 0 vertices precede it"},
      {"trimesh/emptyIO/stl_empty_bin.stl", " no faces, so there is no surface to measure"}};
  for (const auto& [name, reason] : refused) CHECK(outcomes[name].error == reason);

  CHECK(outcomes["tinyobjloader/test-nan.obj"].report.nonfinite_vertices == 4);
  CHECK(outcomes["trimesh/notenoughindices.obj"].report.dropped_short == 1);
  CHECK(outcomes["trimesh/wallhole.obj"].triangles == 66);  // lines continued by a backslash
  CHECK(outcomes["trimesh/whitespace.off"].triangles == 12);
  CHECK(outcomes["real_world_odd/psb_m94_huge_coordinates.off"].triangles == 6328);
  CHECK(outcomes["real_world_odd/psbseg_trailing_xml_281.off"].triangles == 50542);
  CHECK(outcomes["assimp/PLY/cube_binary_starts_with_nl.ply"].triangles == 12);
  CHECK(outcomes["assimp/PLY/cube_binary_header_with_RN_newline.ply"].triangles == 12);
}
