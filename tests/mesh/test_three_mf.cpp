// 3MF: units, components, and files that mean harm.
#include <Eigen/Geometry>

#include "rectilin/mesh/source.h"
#include "support/archives.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::test;
using Catch::Matchers::Contains;

namespace {

/// A tetrahedron whose bounding box is the unit cube.
constexpr const char* kTetrahedron = R"(<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>
<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/>
<triangle v1="1" v2="2" v3="3"/></triangles></mesh></object>)";

LoadedMesh read_3mf(const std::string& objects, const std::string& build,
                    const std::string& attributes = R"(unit="meter")") {
  const ScratchFolder folder;
  const auto file = folder.path() / "test.zip";
  write_archive(
      file,
      {{"[Content_Types].xml",
        R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
       {"_rels/.rels",
        R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
       {"3D/3dmodel.model",
        R"(<?xml version="1.0" encoding="UTF-8"?><model )" + attributes +
            R"( xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)" +
            objects + "</resources><build>" + build + "</build></model>"}});
  return read_mesh(text_of(file), MeshFormat::k3mf, "test.3mf");
}

Vector3 extent(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  return box.max();
}

std::string object(int id, const std::string& components) {
  return "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components>" + components +
         "</components></object>";
}

std::string component(int id, const std::string& more = "") {
  return "<component objectid=\"" + std::to_string(id) + "\" " + more + "/>";
}

}  // namespace

TEST_CASE("3MF: units become metres", "[3mf]") {
  const std::string item = R"(<item objectid="1"/>)";
  CHECK(read_3mf(kTetrahedron, item).mesh.triangles.size() == 4);
  for (const auto& [unit, metres] :
       {std::pair("micron", 1e-6), std::pair("millimeter", 1e-3), std::pair("centimeter", 1e-2),
        std::pair("inch", 0.0254), std::pair("foot", 0.3048), std::pair("meter", 1.0)}) {
    const LoadedMesh loaded = read_3mf(kTetrahedron, item, "unit=\"" + std::string(unit) + "\"");
    CHECK(loaded.report.scene.metres_per_unit == metres);
    CHECK(extent(loaded.mesh) == Vector3(metres, metres, metres));
  }
  CHECK(read_3mf(kTetrahedron, item, "").report.scene.metres_per_unit == 1e-3);  // as the format has it
}

TEST_CASE("3MF: items and components in their places", "[3mf]") {
  const LoadedMesh item = read_3mf(kTetrahedron, R"(<item objectid="1" transform="2 0 0 0 3 0 0 0 4 10 20 30"/>)");
  CHECK(extent(item.mesh) == Vector3(12, 23, 34));
  // x to y and y to -x, then 5 along x: the rows of the attribute are where the axes go.
  const LoadedMesh turned = read_3mf(kTetrahedron, R"(<item objectid="1" transform="0 1 0 -1 0 0 0 0 1 5 0 0"/>)");
  CHECK(turned.mesh.vertices[1] == Vector3(5, 1, 0));
  CHECK(turned.mesh.vertices[2] == Vector3(4, 0, 0));
  // A component moved in an object that is scaled.
  const LoadedMesh nested =
      read_3mf(kTetrahedron + object(2, component(1) + component(1, R"(transform="1 0 0 0 1 0 0 0 1 5 0 0")")),
               R"(<item objectid="2" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>)");
  CHECK(nested.report.scene.instances == 2);
  CHECK(extent(nested.mesh) == Vector3(12, 2, 2));
}

TEST_CASE("3MF: supports are not the object", "[3mf]") {
  std::string support = kTetrahedron;
  support.replace(support.find("id=\"1\""), 6, "id=\"2\"").replace(support.find("\"model\""), 7, "\"support\"");
  const LoadedMesh loaded = read_3mf(kTetrahedron + support, R"(<item objectid="1"/><item objectid="2"/>)");
  CHECK(loaded.report.scene.instances == 1);
}

TEST_CASE("3MF: a hostile file is one error", "[3mf]") {
  std::string chain = kTetrahedron, tower = kTetrahedron;
  for (int i = 2; i < 200; ++i) chain += object(i, component(i - 1));
  for (int i = 2; i < 20; ++i) {
    std::string ten;
    for (int k = 0; k < 10; ++k) ten += component(i - 1);
    tower += object(i, ten);
  }
  CHECK_THROWS_WITH(read_3mf(chain, R"(<item objectid="199"/>)"), Contains("nested too deep"));
  CHECK_THROWS_WITH(read_3mf(tower, R"(<item objectid="19"/>)"), Contains("repeat objects"));
  CHECK_THROWS_AS(read_3mf(kTetrahedron + object(2, component(2)), R"(<item objectid="2"/>)"), MeshError);
  CHECK_THROWS_AS(read_3mf(kTetrahedron, R"(<item objectid="7"/>)"), MeshError);
  CHECK_THROWS_AS(read_3mf(kTetrahedron, ""), MeshError);
  std::string index = kTetrahedron;
  CHECK_THROWS_AS(read_3mf(index.replace(index.find("v3=\"3\""), 6, "v3=\"9\""), R"(<item objectid="1"/>)"), MeshError);
  CHECK_THROWS_WITH(read_3mf(kTetrahedron + std::string(80'000'000, ' '), R"(<item objectid="1"/>)"),
                    Contains("300 times its size"));
  CHECK_THROWS_AS(read_mesh("PK\x03\x04 and no more", MeshFormat::k3mf, "x"), MeshError);
}
