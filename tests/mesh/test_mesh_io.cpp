#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "rectilin/base/random.h"
#include "rectilin/mesh/mesh_io.h"
#include "support/catch.h"
#include "support/surface.h"

using namespace rectilin;
using namespace std::string_literals;

namespace {

LoadedMesh off(const std::string& text) { return read_mesh(text, MeshFormat::kOff, "m"); }
LoadedMesh obj(const std::string& text) { return read_mesh(text, MeshFormat::kObj, "m"); }
LoadedMesh ply(const std::string& text) { return read_mesh(text, MeshFormat::kPly, "m"); }
LoadedMesh stl(const std::string& text) { return read_mesh(text, MeshFormat::kStl, "m"); }

// The message with which reading fails, empty if it does not.
template <class Reader>
std::string error(Reader read, const std::string& text) {
  try {
    read(text);
  } catch (const MeshError& failure) {
    return failure.what();
  }
  return "";
}

// Numbers as bytes in either order.
template <class Number>
std::string raw(Number value, std::endian order = std::endian::little) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Number));
  return order == std::endian::native ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

std::string binary_stl(const std::string& header, std::uint32_t claimed,
                       const std::vector<std::array<float, 9>>& triangles) {
  std::string bytes = header + std::string(80 - header.size(), ' ') + raw(claimed);
  for (const auto& triangle : triangles) {
    bytes += std::string(12, '\0');
    for (const float coordinate : triangle) bytes += raw(coordinate);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

// A polygon in the plane z = 0, as OBJ; (x, y) pairs.
std::string polygon(const std::vector<std::pair<double, double>>& corners) {
  std::string text, face = "f";
  std::size_t number = 0;
  for (const auto& [x, y] : corners) {
    text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    face += " " + std::to_string(++number);
  }
  return text + face + "\n";
}

const std::string kTriangle = "0 0 0\n1 0 0\n0 1 0\n";
const std::string kPlyVertices =
    "element vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n";
const std::string kPlyFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\n";

struct TemporaryFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("rectilin_mesh_io_" + std::to_string(std::random_device{}()));
  TemporaryFolder() { std::filesystem::create_directories(path); }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path / name, std::ios::binary) << bytes;
    return path / name;
  }
};

}  // namespace

TEST_CASE("OFF: headers and the data they announce") {
  const std::string face = "3 0 1 2\n";
  CHECK(test::surface(off("OFF\n3 1 0\n" + kTriangle + face).mesh) == 0.5);
  CHECK(test::surface(off("OFF3 1 0\n" + kTriangle + face).mesh) == 0.5);  // as in ModelNet
  CHECK(test::surface(off("\n# note\nOFF # note\n\n3 1\n#\n" + kTriangle + face).mesh) == 0.5);
  CHECK(test::surface(off("\xEF\xBB\xBFOFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2").mesh) == 0.5);
  CHECK(test::surface(off("OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r").mesh) == 0.5);
  CHECK(test::surface(off("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 255 0 0\n" + face).mesh) == 0.5);
  CHECK(test::surface(off("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n" + face).mesh) == 0.5);
  CHECK(test::surface(off("STCN4nOFF\n3\n3 1 0\n0 0 0 1\n2 0 0 2\n0 3 0 3\n" + face).mesh) == 0.5);
}

TEST_CASE("OFF: faces with colours, of many corners, over several lines, with more text after them") {
  const std::string square = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  CHECK(test::surface(off(square + "4 0 1 2 3 0.5 0.5 0.5 1\n").mesh) == 1);
  CHECK(test::surface(off(square + "4 0 1 2 3  # red\n").mesh) == 1);
  CHECK(test::surface(off(square + "4 0\n1\n2\n3\n").mesh) == 1);
  const LoadedMesh loaded = off(square + "4 0 1 2 3\n<xml>\n");
  CHECK(loaded.mesh.triangles.size() == 2);
  CHECK(loaded.report.polygons == 1);
  CHECK(loaded.report.triangulated == 1);
}

TEST_CASE("OFF: errors name the line") {
  const std::string head = "OFF\n3 1 0\n";
  CHECK(error(off, "PFF\n3 1 0\n") == "m:line 1: expected the keyword OFF, found 'PFF'");
  CHECK(error(off, "OFF BINARY\n") == "m:line 1: OFF BINARY is not supported, only OFF as text");
  CHECK(error(off, "OFF\nx 1 0\n") == "m:line 2: expected the number of vertices, found 'x'");
  CHECK(error(off, "OFF\n-3 1 0\n") == "m:line 2: expected the number of vertices, found '-3'");
  CHECK(error(off, "nOFF\n4\n3 1 0\n") == "m:line 2: only vertices of three dimensions are supported");
  CHECK(error(off, head + "0.0 0.0 0.0\n1.0 0.0 0.0\n") == "m:line 4: the file ends after 2 of 3 vertices");
  CHECK(error(off, head + "0.0 0.0\n1.0 0.0 0.0\n") == "m:line 3: expected a coordinate, found the end of the line");
  CHECK(error(off, head + "0 0 0x1\n1 0 0\n") == "m:line 3: expected a coordinate, found '0x1'");
  CHECK(error(off, head + kTriangle) == "m:line 5: the file ends after 0 of 1 faces");
  CHECK(error(off, head + kTriangle + "3 0 1 3\n") == "m:line 6: vertex index 3 is not in 0..2");
  CHECK(error(off, head + kTriangle + "3 0 1 -1\n") == "m:line 6: vertex index -1 is not in 0..2");
  CHECK(error(off, head + kTriangle + "-3 0 1 2\n") == "m:line 6: a face of -3 corners");
  CHECK(error(off, head + kTriangle + "9999999999 0 1 2\n") ==
        "m:line 6: expected a vertex index, found the end of the file");
  CHECK(error(off, head + kTriangle + "4 0 1 2\n2 0 1\n") ==
        "m:line 7: expected the end of a face that began on a line above, found '0'");
  CHECK(error(off, "OFF\n0 0 0\n") == "m: no faces, so there is no surface to measure");
}

TEST_CASE("OBJ: what faces are made of") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* face : {"f 1 2 3", "f -3 -2 -1", "f 1/1 2/2 3/3", "f 1//7 2//7 3//7", "f 1/1/1 2/ 3//",
                           "f 1 2\\\n 3\n", "f 1 \\\r\n2 \\\r\n3\r\n", "  f\t1 2 3 # note"}) {
    CAPTURE(face);
    CHECK(test::surface(obj(vertices + face).mesh) == 0.5);
  }
  CHECK(test::surface(obj("f 1 2 3\n" + vertices).mesh) == 0.5);  // faces may come first
  CHECK(test::surface(obj("# f 1\nmtllib f.mtl\no f\nl 1 2\np 1\nvn 0 0 1\nvt 0 0\n" + vertices +
                          "v 0 0 0 1 0 0\nusemtl f 1\ns off\ng f 9\nf 1 2 3")
                          .mesh) == 0.5);
}

TEST_CASE("OBJ: errors name the line") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(error(obj, vertices + "f 1 2 0\n") == "m:line 4: vertex index 0, but the first vertex is 1");
  CHECK(error(obj, vertices + "f 1 2 -4\n") == "m:line 4: vertex index -4, but only 3 vertices precede it");
  CHECK(error(obj, vertices + "\nf 1 2 4\nf 1 2 3\n") == "m:line 5: vertex index 4, but there are 3 vertices");
  CHECK(error(obj, vertices + "f 1 2 4294967297\n") == "m:line 4: vertex index 4294967297, but there are 3 vertices");
  CHECK(error(obj, vertices + "f 1 2 x\n") == "m:line 4: expected a vertex index, found 'x'");
  CHECK(error(obj, vertices + "f 1 2 /3\n") == "m:line 4: expected a vertex index, found '/3'");
  CHECK(error(obj, vertices + "f 1 2 3.5\n") == "m:line 4: expected a vertex index, found '3.5'");
  CHECK(error(obj, "v 0 0\n") == "m:line 1: expected a coordinate, found the end of the line");
  CHECK(error(obj, "v 0 0 3.1+e2\n") == "m:line 1: expected a coordinate, found '3.1+e2'");
  CHECK(error(obj, vertices) == "m: no faces, so there is no surface to measure");
  CHECK(error(obj, "\xFF\xFEv") == "m:byte 0: UTF-16 text is not supported");
  CHECK(error(obj, "") == "m: the file is empty");
}

TEST_CASE("numbers keep all their digits, and may be written in any usual way") {
  const Mesh mesh = obj("v 0.1 +2. .5\nv 1e-3 -4.25E+2 1e-400\nv 0 1 0\nf 1 2 3").mesh;
  CHECK(mesh.vertices[0] == Vector3(0.1, 2, 0.5));
  CHECK(mesh.vertices[1] == Vector3(0.001, -425, 0));
}

TEST_CASE("PLY as text: all element orders, list types and property names") {
  const std::string head = "ply\nformat ascii 1.0\ncomment #1\nobj_info x\n";
  CHECK(test::surface(ply(head + kPlyVertices + kPlyFaces + "end_header\n" + kTriangle + "3 0 1 2\n").mesh) == 0.5);
  CHECK(test::surface(ply(head + kPlyFaces + kPlyVertices + "end_header\n3 0 1 2\n" + kTriangle).mesh) == 0.5);
  CHECK(test::surface(ply("ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float64 z\r\n"
                          "property uint8 red\r\nproperty float64 y\r\nproperty float64 x\r\n"
                          "element camera 1\r\nproperty list uint float focus\r\nelement nothing 7\r\n"
                          "element face 1\r\nproperty list int float uv\r\n"
                          "property list int32 uint16 vertex_index\r\nend_header\r\n"
                          "0 255 0 0\r\n0 255 0 1\r\n0 255 1 0\r\n2 0.5 0.5\r\n1 0.5 3 0 1 2\r\n")
                          .mesh) == 0.5);
}

TEST_CASE("PLY binary: both byte orders, every line ending of the header") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const std::string& ending : {"\n"s, "\r\n"s, "\r"s}) {
      std::string text = "ply\nformat binary_"s + (order == std::endian::little ? "little" : "big") +
                         "_endian 1.0\nelement vertex 4\nproperty char tag\nproperty float x\n"
                         "property double y\nproperty short z\nelement face 1\n"
                         "property list ushort uint vertex_indices\nproperty double quality\n"
                         "end_header\n";
      for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += ending.size()) {
        text.replace(at, 1, ending);
      }
      // The first byte of the body is a line feed, which must not be taken for half a line ending.
      for (const auto& [x, y] : {std::pair(0, 0), {2, 0}, {2, 3}, {0, 3}}) {
        text.append("\n").append(raw(static_cast<float>(x), order));
        text += raw(static_cast<double>(y), order) + raw(static_cast<std::int16_t>(-7), order);
      }
      text += raw(std::uint16_t{4}, order);
      for (std::uint32_t i = 0; i < 4; ++i) text += raw(i, order);
      text += raw(1.0, order);
      const Mesh mesh = ply(text).mesh;
      CHECK(test::surface(mesh) == 6);
      CHECK(mesh.vertices[2] == Vector3(2, 3, -7));
      CHECK_THAT(error(ply, text.substr(0, text.size() - 1)),
                 Catch::Matchers::Contains("the file ends within a value"));
    }
  }
}

TEST_CASE("PLY: triangle strips") {
  const LoadedMesh loaded =
      ply("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
          "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
          "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 -1\n");
  CHECK(loaded.report.polygons == 3);
  // The second triangle of a strip is turned, so that all have the same side up.
  CHECK(loaded.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}

TEST_CASE("PLY: errors name the line or the byte") {
  const std::string head = "ply\nformat ascii 1.0\n" + kPlyVertices + kPlyFaces + "end_header\n";
  CHECK(error(ply, "plx\n") == "m:line 1: expected ply on the first line");
  CHECK(error(ply, "ply\nformat ascii 1.0\n") == "m:line 2: the file ends within the header");
  CHECK(error(ply, "ply\nformat binary 1.0\n") ==
        "m:line 2: expected ascii, binary_little_endian or binary_big_endian, found 'binary'");
  CHECK(error(ply, "ply\nproperty float x\n") == "m:line 2: a property before any element");
  CHECK(error(ply, "ply\nelement face -1\n") == "m:line 2: a negative count of elements");
  CHECK(error(ply, "ply\nelement face 1\nproperty list float int vertex_index\n") ==
        "m:line 3: a list whose count is no integer");
  CHECK(error(ply, "ply\nelement vertex 1\nproperty real x\n") == "m:line 3: expected a type, found 'real'");
  CHECK(error(ply, "ply\nend_header\n") == "m:line 2: the header has no line format");
  CHECK(error(ply, "ply\nbogus\n") == "m:line 2: expected a header line, found 'bogus'");
  CHECK(error(ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n") ==
        "m:line 3: the vertices have no x, y and z");
  CHECK(error(ply, "ply\nformat ascii 1.0\n" + kPlyVertices + "element face 1\nproperty uchar red\nend_header\n" +
                       kTriangle + "0\n") == "m:line 7: the faces have no list vertex_indices or vertex_index");
  CHECK(error(ply, head + kTriangle + "3 0 1 3\n") == "m:line 13: vertex index 3, but there are 3 vertices");
  CHECK(error(ply, head + kTriangle + "3 0 1 -1\n") == "m:line 13: vertex index -1, but there are 3 vertices");
  CHECK(error(ply, head + kTriangle + "3 0 1 1.5\n") == "m:line 13: a list's length or an index is not an integer");
  CHECK(error(ply, head + kTriangle + "3 0 1\n") == "m:line 13: expected a number, found the end of the file");
  CHECK(error(ply, head + kTriangle + "3 0 1 2 3\n") == "m:line 13: expected the end of the line, found '3'");
  CHECK(error(ply, head + kTriangle + "-1 0 1 2\n") == "m:line 13: a list of negative length");
  const std::string binary =
      "ply\nformat binary_big_endian 1.0\n" + kPlyVertices + kPlyFaces + "end_header\n" + std::string(36, '\0') + "\3";
  CHECK(error(ply, binary + std::string(4, '\7')) == "m:byte " + std::to_string(binary.size() + 4) +
                                                         ": vertex index 117901063, but there are 3"
                                                         " vertices");
}

TEST_CASE("STL: text and binary, welded") {
  for (const std::string& text :
       {"solid a\n" + kFacet + kFacet + "endsolid a\n",
        "solid a\n" + kFacet + "endsolid\n\nsolid b\n" + kFacet + "endsolid b",
        "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\n"
        "ENDFACET\n" +
            kFacet + "ENDSOLID\n",
        binary_stl("made here", 2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {-0.0f, 0, 0, 1, 0, 0, 0, 1, 0}}),
        binary_stl("solid facet", 2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0}})}) {
    const LoadedMesh loaded = stl(text);
    CHECK(loaded.report.vertices == 6);
    CHECK(loaded.report.duplicate_vertices == 0);
    CHECK(loaded.mesh.vertices.size() == 3);
    CHECK(loaded.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}});
  }
}

TEST_CASE("STL: errors name the line or the byte") {
  CHECK(error(stl, "solid\n" + kFacet) == "m:line 8: the file ends before endsolid");
  CHECK(error(stl, "solid\n" + kFacet.substr(0, 40)) ==
        "m:line 4: expected a coordinate, found the "
        "end of the file");
  CHECK(error(stl, "solid\nfacet\nvertex 0 0 0\n") == "m:line 3: the file ends within a facet");
  CHECK(error(stl, "solid\nvertex 0 0 0\n") == "m:line 2: expected facet or endsolid, found 'vertex'");
  CHECK(error(stl, "solid\nfacet\nvortex 0 0 0\n") == "m:line 3: expected a vertex or endfacet, found 'vortex'");
  CHECK(error(stl, "solid\nendsolid\n") == "m: no faces, so there is no surface to measure");
  CHECK(error(stl, binary_stl("", 3, {{}, {}})) == "m:byte 84: the header claims 3 triangles, the file holds 2");
  CHECK(error(stl, "short") == "m:byte 5: the file ends within a value");
}

TEST_CASE("what is odd but legal is kept or dropped, and counted") {
  const std::string vertices =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 9 9 9\nv nan 0 0\nv 0 -inf 0\n"
      "v 1e999 0 0\nv 1.#IND 0 0\n";
  const LoadedMesh loaded = obj(vertices +
                                "f 1 2 3\nf 1 3 2\nf 1 1 2\nf 1 2 4\nf 1 2 6\nf 7 8 9 1\n"
                                "f 1 2\nf\nf 3 2 1 4\n");
  const MeshReport& report = loaded.report;
  CHECK(report.vertices == 9);
  CHECK(report.polygons == 9);
  CHECK(report.nonfinite_vertices == 4);
  CHECK(report.dropped_nonfinite == 2);
  CHECK(report.dropped_short == 2);
  CHECK(report.degenerate == 3);  // twice one corner, twice one position, and part of the quadrangle
  CHECK(report.duplicate_vertices == 1);
  CHECK(report.unreferenced_vertices == 1);
  CHECK(report.triangulated == 1);
  CHECK(loaded.mesh.vertices.size() == 5);
  CHECK(loaded.mesh.triangles.size() == 6);
  CHECK(test::surface(loaded.mesh) == 1.5);
}

TEST_CASE("a mesh without area is refused, at any scale one with area is not") {
  CHECK(error(obj, "v 0 0 0\nv 1 1 1\nv 3 3 3\nf 1 2 3\n") == "m: the total area is zero");
  CHECK(error(obj, "v 5 5 5\nf 1 1 1\n") == "m: the total area is zero");
  CHECK_THAT(error(obj, "v nan 0 0\nf 1 1 1\n"), Catch::Matchers::Contains("no triangle is left"));
  for (const char* unit : {"1e-307", "1e-120", "1e+120", "1.7e308"}) {
    CAPTURE(unit);
    const std::string u = unit;
    const LoadedMesh loaded = obj("v 0 0 0\nv " + u + " 0 0\nv " + u + " " + u + " 0\nv 0 " + u + " 0\nv -" + u +
                                  " 0 0\nf 1 2 3 4\nf 5 1 4\n");
    CHECK(loaded.report.degenerate == 0);
    CHECK(loaded.mesh.triangles.size() == 3);
  }
}

TEST_CASE("triangles of a planar polygon have its area") {
  SECTION("an arrow head, from every first corner") {
    std::vector<std::pair<double, double>> corners = {{0, 0}, {4, 2}, {0, 4}, {1, 2}};
    for (int turn = 0; turn < 4; ++turn) {
      CHECK(test::surface(obj(polygon(corners)).mesh) == 6);
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
  }
  SECTION("a comb, both ways round, in a tilted plane") {
    std::vector<std::pair<double, double>> corners = {{20, -1}, {0, -1}};
    for (int i = 0; i < 20; ++i) corners.insert(corners.end(), {{i, 0}, {i + 0.5, 3}});
    corners.push_back({20, 0});
    const double expected = 20 + 20 * 1.5;  // the bar and the triangular teeth
    CHECK(test::surface(obj(polygon(corners)).mesh) == Approx(expected).epsilon(1e-12));
    std::reverse(corners.begin(), corners.end());
    std::string text = polygon(corners);
    Mesh mesh = obj(text).mesh;
    CHECK(test::surface(mesh) == Approx(expected).epsilon(1e-12));
    CHECK(mesh.triangles.size() == corners.size() - 2);
    std::string tilted, face = text.substr(text.find('f'));
    for (const Vector3& v : mesh.vertices) {  // stretches areas by sqrt(1 + 1 + 4)
      tilted +=
          "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.x() + 2 * v.y()) + "\n";
    }
    CHECK(test::surface(obj(tilted + face).mesh) == Approx(expected * std::sqrt(6)).epsilon(1e-12));
  }
  SECTION("a square with a square hole, joined by a channel of no width") {
    CHECK(test::surface(
              obj(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}})).mesh) ==
          12);
  }
  SECTION("straight and repeated corners") {
    CHECK(test::surface(obj(polygon({{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 2}, {1, 1}, {1, 1}, {0, 2}})).mesh) == 3);
  }
}

TEST_CASE("large polygons keep their areas") {
  const auto points = [](int count, auto place) {
    std::vector<std::pair<double, double>> corners;
    for (int i = 0; i < count; ++i) corners.push_back(place(i));
    return corners;
  };
  const auto exact = [](const std::vector<std::pair<double, double>>& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [x, y] = corners[i];
      const auto& [u, v] = corners[(i + 1) % corners.size()];
      twice += x * v - u * y;
    }
    return std::abs(twice) / 2;
  };
#ifdef NDEBUG
  constexpr int kCorners = 50000, kSpiral = 20000;
#else
  constexpr int kCorners = 5000, kSpiral = 4000;
#endif
  constexpr double kTurn = 2 * std::numbers::pi;
  const auto polar = [](double radius, double angle) {
    return std::pair(radius * std::cos(angle), radius * std::sin(angle));
  };
  const auto circle = points(kCorners, [&](int i) { return polar(1, kTurn * i / kCorners); });
  const auto star = points(kCorners, [&](int i) { return polar(i % 2 == 0 ? 1 : 0.5, kTurn * i / kCorners); });
  // The wall of a spiral of 50 turns: out on one side, back on the other.
  const auto spiral = points(kSpiral, [&](int i) {
    const bool out = i < kSpiral / 2;
    const double along = 2.0 * (out ? i : kSpiral - 1 - i) / kSpiral;
    return polar((out ? 1 : 1.4) + 50 * along, 50 * kTurn * along);
  });
  for (const auto& corners : {circle, star, spiral}) {
    const Mesh mesh = obj(polygon(corners)).mesh;
    CHECK(mesh.triangles.size() == corners.size() - 2);
    CHECK(test::surface(mesh) == Approx(exact(corners)).epsilon(1e-6));
  }
}

TEST_CASE("a polygon that crosses itself has triangles, or too many corners for them") {
  Random random(1);
  std::vector<std::pair<double, double>> corners;
  for (int i = 0; i < 8000; ++i) corners.emplace_back(random.uniform(), random.uniform());
  CHECK(error(obj, polygon(corners)) == "m: polygon 1 has 8000 corners and is too intricate to be cut into triangles");
  corners.resize(200);
  CHECK(obj(polygon(corners)).mesh.triangles.size() == 198);
}

TEST_CASE("a lying header costs no memory") {
  CHECK(error(off, "OFF\n353535235358 6 0\n0 0 0\n") ==
        "m:line 2: the header claims 353535235358 vertices and 6 faces, more than the file can hold");
  CHECK(error(off, "OFF\n9223372036854775807 9223372036854775807 0\n") ==
        "m:line 2: the header claims 9223372036854775807 vertices and 9223372036854775807 faces, "
        "more "
        "than the file can hold");
  CHECK(error(ply,
              "ply\nformat ascii 1.0\nelement vertex 9223372036854775807\nproperty float x\n"
              "property float y\nproperty float z\nend_header\n0 0 0\n") ==
        "m:line 3: the header claims 9223372036854775807 of the element 'vertex', more than the file "
        "can hold");
  CHECK(error(ply, "ply\nformat ascii 1.0\nelement junk 9223372036854775807\nend_header\n") ==
        "m: no faces, so there is no surface to measure");
  CHECK(error(stl, binary_stl("", 0xFFFFFFFFu, {{}})) ==
        "m:byte 84: the header claims 4294967295 triangles, the file holds 1");
}

TEST_CASE("the content decides the format, else the extension") {
  const TemporaryFolder folder;
  const std::string ascii_ply =
      "ply\nformat ascii 1.0\n" + kPlyVertices + kPlyFaces + "end_header\n" + kTriangle + "3 0 1 2\n";
  for (const std::string& bytes :
       {"OFF\n3 1 0\n" + kTriangle + "3 0 1 2\n", ascii_ply, "solid\n" + kFacet + "endsolid\n",
        binary_stl("solid", 1, {{0, 0, 0, 1, 0, 0, 0, 1, 0}})}) {
    CHECK(test::surface(read_mesh(folder.write("misnamed.obj", bytes)).mesh) == 0.5);
  }
  const std::string wavefront = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  CHECK(test::surface(read_mesh(folder.write("named.OBJ", wavefront)).mesh) == 0.5);
  CHECK_THROWS_WITH(read_mesh(folder.write("named.xyz", wavefront)),
                    Catch::Matchers::Contains("neither content nor name tell a known format"));
}

TEST_CASE("files that cannot be read or written give one clear error") {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path / name).string(); };
  CHECK_THROWS_WITH(read_mesh(folder.path), folder.path.string() + ": is a directory");
  CHECK_THROWS_WITH(read_mesh(folder.path / "none.off"), path("none.off") + ": no such file or directory");
  CHECK_THROWS_WITH(read_mesh(folder.write("empty.stl", "")), path("empty.stl") + ": the file is empty");
  const Mesh mesh = obj("v 0 0 0\nv 1 0 0\nv 0 1e39 0\nf 1 2 3\n").mesh;
  CHECK_THROWS_WITH(write_mesh(folder.path / "none" / "a.off", mesh),
                    path("none/a.off") + ": cannot be written: no such file or directory");
  CHECK_THROWS_WITH(write_mesh(folder.path / "a.xyz", mesh),
                    path("a.xyz") + ": the extension is none of .off, .obj, .ply, .stl");
  CHECK_THROWS_WITH(write_mesh(folder.path / "a.stl", mesh),
                    path("a.stl") + ": a coordinate is too large for the single precision of binary STL");
}

TEST_CASE("what is written reads back the same") {
  const TemporaryFolder folder;
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const Mesh mesh{{{0.1, 1.0 / 3.0, -1e-300}, {kTiny, 2e10, 3}, {4, 5, 6.000000000000001}, {7, 8, -0.0}},
                  {{0, 1, 2}, {3, 2, 1}, {0, 0, 3}}};
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"}) {
    for (const bool binary : {false, true}) {
      const std::filesystem::path file = folder.path / name;
      write_mesh(file, mesh, {.binary = binary});
      const LoadedMesh back = read_mesh(file);
      CAPTURE(name, binary);
      CHECK(back.mesh.triangles.size() == mesh.triangles.size());
      const bool single = binary && std::string(name) == "a.stl";
      REQUIRE(back.mesh.vertices.size() == mesh.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          const double written = mesh.vertices[i][k];
          CHECK(back.mesh.vertices[i][k] == (single ? static_cast<float>(written) : written));
        }
      }
      CHECK(back.mesh.triangles == mesh.triangles);
    }
  }
}
