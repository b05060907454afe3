// glTF: scenes, instances, buffers, and files that mean harm.
#include <Eigen/Geometry>
#include <fstream>

#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"
#include "support/gltf_file.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::test;
using Catch::Matchers::Contains;

namespace {

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = mesh.vertices[t[0]];
    area += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  return area;
}

Eigen::AlignedBox3d box_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

LoadedMesh read(const Json& json, const std::string& buffer = cube_buffer()) {
  return read_mesh(glb(json, buffer), MeshFormat::kGltf, "test.glb");
}

}  // namespace

TEST_CASE("glTF: a cube", "[gltf]") {
  const LoadedMesh cube = read(cube_json());
  CHECK(cube.mesh.triangles.size() == 12);
  CHECK(cube.mesh.vertices.size() == 8);
  CHECK(area_of(cube.mesh) == 6);
  CHECK(cube.report.scene.metres_per_unit == 1);
  CHECK(cube.report.scene.instances == 1);
}

TEST_CASE("glTF: the scene places meshes", "[gltf]") {
  Json json = cube_json();
  // A parent that scales by 2 and a child that has moved and turned in the parent's coordinates; a node that no scene
  // shows.
  json["nodes"] = Json::parse(R"([{"mesh": 0, "scale": [2, 2, 2], "children": [1]},
    {"mesh": 0, "translation": [3, 0, 0], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752]},
    {"mesh": 0, "scale": [100, 100, 100]}])");
  const LoadedMesh scene = read(json);
  CHECK(scene.report.scene.instances == 2);
  CHECK(summary(scene.report) == "left out: 1 mesh not in the scene");
  CHECK(area_of(scene.mesh) == Approx(48));
  const auto box = box_of(scene.mesh);  // the child: x in 2 (3 + [-1, 0])
  CHECK(box.max()[0] == Approx(6));
  CHECK(box.max()[1] == Approx(2));

  json["nodes"] = Json::parse(R"([{"mesh": 0, "matrix": [1,0,0,0, 0,3,0,0, 0,0,1,0, 5,6,7,1]}])");
  const auto moved = box_of(read(json).mesh);
  CHECK(moved.min() == Vector3(5, 6, 7));
  CHECK(moved.max() == Vector3(6, 9, 8));
}

TEST_CASE("glTF: what is not in the mesh is said", "[gltf][loss]") {
  CHECK(summary(read(cube_json()).report) == "");
  const std::string file = glb(cube_json(), cube_buffer());
  CHECK(summary(read_mesh(file + "more", MeshFormat::kGltf, "test.glb").report) ==
        "left out: 4 bytes of data behind the last face (byte " + std::to_string(file.size()) + ")");
  CHECK(summary(read_mesh(file + std::string(3, '\0'), MeshFormat::kGltf, "test.glb").report) ==
        "there are 3 bytes of padding at the end");

  Json json = cube_json();
  json["meshes"].push_back(json["meshes"][0]);  // that no node has
  json["scenes"].push_back({{"nodes", {1}}});   // another scene
  json["nodes"].push_back({{"mesh", 0}});
  CHECK(summary(read(json).report) == "left out: 2 meshes not in the scene");

  json = cube_json();
  json["meshes"][0]["primitives"][0]["targets"] = Json::parse(R"([{"POSITION": 0}])");
  CHECK(summary(read(json).report) == "there is 1 mesh whose skin or morph targets are not applied");

  json = cube_json();
  for (Json& accessor : json["accessors"])
    if (accessor["count"] == 36) accessor["count"] = 35;
  const LoadedMesh cut = read(json);
  CHECK(cut.mesh.triangles.size() == 11);
  CHECK(summary(cut.report) == "left out: 1 face of fewer than three corners");
}

TEST_CASE("glTF: instances by the extension", "[gltf]") {
  Json json = cube_json();
  std::string buffer = cube_buffer();
  for (const float x : {0.f, 0.f, 0.f, 5.f, 0.f, 0.f}) append_raw(buffer, x);
  json["buffers"][0]["byteLength"] = 192;
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 168}, {"byteLength", 24}});
  json["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}});
  json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 2;
  const LoadedMesh two = read(json, buffer);
  CHECK(two.report.scene.instances == 2);
  CHECK(area_of(two.mesh) == 12);
  CHECK(box_of(two.mesh).max()[0] == 6);
}

TEST_CASE("glTF: strips, fans, no indices, small integers, sparse values, lines", "[gltf]") {
  Json json = cube_json();
  Json& primitive = json["meshes"][0]["primitives"][0];
  SECTION("a strip of the corners 0 1 3 has one triangle, of 0 1 3 0 two") {
    primitive["mode"] = 5;
    json["accessors"][1]["count"] = 4;
    CHECK(read(json).mesh.triangles.size() == 2);
  }
  SECTION("a fan") {
    primitive["mode"] = 6;
    json["accessors"][1]["count"] = 3;
    CHECK(area_of(read(json).mesh) == 0.5);
  }
  SECTION("every three vertices") {
    primitive.erase("indices");
    CHECK(read(json).mesh.triangles.size() == 2);
  }
  SECTION("lines have no area") {
    json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
    CHECK(read(json).report.scene.skipped == 1);
    json["meshes"][0]["primitives"][0]["mode"] = 0;
    CHECK_THROWS_WITH(read(json), Contains("no faces"));
  }
  SECTION("normalized bytes") {
    std::string buffer;
    for (int i = 0; i < 8; ++i) {
      for (const int bit : {4, 2, 1}) buffer += (i & bit) ? '\xff' : '\0';
      buffer += '\0';
    }
    buffer += cube_buffer().substr(96);
    json["accessors"][0]["componentType"] = 5121;
    json["accessors"][0]["normalized"] = true;
    json["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 32}, {"byteStride", 4}};
    json["bufferViews"][1]["byteOffset"] = 32;
    json["buffers"][0]["byteLength"] = 104;
    CHECK(area_of(read(json, buffer).mesh) == 6);
  }
  SECTION("a sparse value moves corner 7 to (1, 1, 3)") {
    std::string buffer = cube_buffer();
    for (const float x : {1.f, 1.f, 3.f}) append_raw(buffer, x);
    append_raw(buffer, std::uint32_t{7});
    json["buffers"][0]["byteLength"] = 184;
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 168}, {"byteLength", 16}});
    json["accessors"][0]["sparse"] = {{"count", 1},
                                      {"indices", {{"bufferView", 2}, {"byteOffset", 12}, {"componentType", 5125}}},
                                      {"values", {{"bufferView", 2}}}};
    CHECK(box_of(read(json, buffer).mesh).max()[2] == 3);
  }
}

TEST_CASE("glTF: buffers are read from files beside and below, and from nowhere else", "[gltf]") {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "in" / "data");
  std::ofstream(folder.path() / "in" / "data" / "a+b c.bin", std::ios::binary) << cube_buffer();
  std::ofstream(folder.path() / "outside.bin", std::ios::binary) << cube_buffer();
  std::filesystem::create_symlink("../outside.bin", folder.path() / "in" / "link.bin");
  const auto file = folder.path() / "in" / "cube.gltf";
  const auto load = [&](const std::string& uri) {
    Json json = cube_json();
    json["buffers"][0]["uri"] = uri;
    std::ofstream(file) << json;
    return load_mesh(file.string());
  };
  CHECK(area_of(load("data/a+b%20c.bin").mesh) == 6);
  for (const std::string& uri : {std::string("../outside.bin"), std::string("link.bin"),
                                 std::string("data/../../outside.bin"), (folder.path() / "outside.bin").string()})
    CHECK_THROWS_WITH(load(uri), Contains("outside its folder"));
  CHECK_THROWS_WITH(load("missing.bin"), Contains("no such file"));

  Json json = cube_json();
  json["images"] = Json::parse(R"([{"uri": "../../../etc/passwd"}, {"uri": "missing.png"}])");
  CHECK(read(json).mesh.triangles.size() == 12);  // images are not looked for
}

TEST_CASE("glTF: a hostile file is one error", "[gltf]") {
  Json json = cube_json();
  SECTION("counts and offsets beyond the buffer") {
    const std::uint64_t huge = std::uint64_t{1} << 62;
    for (const char* pointer : {"/accessors/0/count", "/accessors/1/count", "/accessors/0/byteOffset",
                                "/bufferViews/0/byteLength", "/bufferViews/1/byteOffset"}) {
      Json changed = json;
      changed[Json::json_pointer(pointer)] = huge;
      CHECK_THROWS_AS(read(changed), MeshError);
    }
    json["buffers"][0]["byteLength"] = huge;
    CHECK_THROWS_WITH(read(json), Contains("claim more than"));
  }
  SECTION("numbers of things that do not exist") {
    for (const char* pointer :
         {"/scene", "/nodes/0/mesh", "/meshes/0/primitives/0/indices", "/accessors/0/bufferView",
          "/meshes/0/primitives/0/attributes/POSITION", "/bufferViews/0/buffer", "/scenes/0/nodes/0"}) {
      for (const int wrong : {9, -7}) {
        Json changed = json;
        changed[Json::json_pointer(pointer)] = wrong;
        if (wrong > 0) CHECK_THROWS_AS(read(changed), MeshError);
        else try {
            read(changed);  // negative numbers may stand for nothing
          } catch (const MeshError&) {
          }
      }
    }
  }
  SECTION("nodes in a circle, and with two parents") {
    json["nodes"] = Json::parse(R"([{"mesh": 0, "children": [1]}, {"children": [0]}])");
    CHECK_THROWS_WITH(read(json), Contains("two parents"));
    json["nodes"] = Json::parse(R"([{"children": [1, 1]}, {"mesh": 0}])");
    CHECK_THROWS_WITH(read(json), Contains("two parents"));
  }
  SECTION("one buffer many times") {
    for (int i = 0; i < 1000; ++i) json["buffers"].push_back(json["buffers"][0]);
    CHECK_THROWS_WITH(read(json), Contains("has no data"));
  }
  SECTION("more instances than fit") {
    json["accessors"].push_back(
        Json::parse(R"({"componentType": 5126, "count": 5000000, "type": "VEC3", "sparse": {"count": 1,
      "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}}})"));
    json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 2;
    CHECK_THROWS_WITH(read(json), Contains("instances come to more than"));
  }
  SECTION("brackets") {
    const std::string text = R"({"asset":{"version":"2.0"},"extras":)" + std::string(100000, '[');
    CHECK_THROWS_WITH(read_mesh(text, MeshFormat::kGltf, "x"), Contains("nested too deep"));
  }
  SECTION("cut off anywhere") {
    const std::string whole = glb(json, cube_buffer());
    for (std::size_t size = 0; size < whole.size(); size += 7)
      CHECK_THROWS_AS(read_mesh(whole.substr(0, size), MeshFormat::kGltf, "x"), MeshError);
  }
  SECTION("compressed geometry") {
    json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    CHECK_THROWS_WITH(read(json), Contains("KHR_draco_mesh_compression"));
  }
}
