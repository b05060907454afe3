// Nothing of a file is lost silently: it is read, or said to be left out, or refused.
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "rectilin/mesh/mesh_io.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"
#include "support/surface.h"

using namespace rectilin;
using namespace std::string_literals;

namespace {

LoadedMesh read(MeshFormat format, const std::string& text) { return read_mesh(text, format, "m"); }

/// What is said of a file that is read; "refused: ..." of one that is not.
std::string said(MeshFormat format, const std::string& text) {
  try {
    return summary(read(format, text).report);
  } catch (const MeshError& error) {
    return "refused: "s + error.what();
  }
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

template <class Number>
std::string raw_bytes(Number value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Triangles (i, 0, 0), (i + 1, 0, 0), (i, 1, 0), each with so many bytes behind it.
std::string binary_stl(std::uint32_t count, std::uint32_t claimed, std::uint16_t payload = 0,
                       std::string header = "binary") {
  header.resize(80, ' ');
  std::string bytes = header + raw_bytes(claimed);
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes += std::string(12, '\0');
    const float x = static_cast<float>(i);
    for (const float coordinate : {x, 0.0f, 0.0f, x + 1, 0.0f, 0.0f, x, 1.0f, 0.0f}) bytes += raw_bytes(coordinate);
    bytes += raw_bytes(payload) + std::string(payload, '\x07');
  }
  return bytes;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

const std::string kVertices = "0 0 0\n1 0 0\n0 1 0\n";
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kOff = "OFF\n3 1 0\n" + kVertices + "3 0 1 2\n";
const std::string kPlyHead =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kPly = "ply\nformat ascii 1.0\n" + kPlyHead + kVertices + "3 0 1 2\n";

std::string binary_ply() {
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + kPlyHead;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw_bytes(x);
  bytes += raw_bytes(std::uint8_t{3});
  for (const int i : {0, 1, 2}) bytes += raw_bytes(i);
  return bytes;
}

}  // namespace

TEST_CASE("binary STL: every byte of a file is accounted for", "[loss]") {
  const auto stl = [](const std::string& bytes) { return said(MeshFormat::kStl, bytes); };
  const std::string good = binary_stl(3, 3);
  CHECK(stl(good) == "");
  CHECK(stl(binary_stl(3, 3, 0, "solid by an exporter that does not care")) == "");
  CHECK(stl(binary_stl(3, 3, 0, "PK\x03\x04")) == "");

  SECTION("padding is reported") {
    for (const std::string& tail : {"\n"s, "\0"s, std::string(400, '\0'), " \r\n\0\x1A"s}) {
      const LoadedMesh loaded = read(MeshFormat::kStl, good + tail);
      CHECK(loaded.mesh.triangles.size() == 3);
      CHECK(loaded.report.padding_bytes == tail.size());
      CHECK(contains(summary(loaded.report), "of padding"));
      CHECK(summary(read(MeshFormat::kStl, binary_stl(3, 3, 0, "solid a") + tail).report) != "");
    }
  }
  SECTION("anything else is refused, with what it may be") {
    CHECK(contains(stl(good + good), "2 binary STL files"));
    CHECK(contains(stl(good + binary_stl(1, 1) + binary_stl(2, 2)), "3 binary STL files"));
    CHECK(contains(stl(binary_stl(3, 3, 6)), "more data behind each triangle"));
    CHECK(contains(stl(binary_stl(3, 2)), "claims 2 triangles, but 50 bytes follow"));
    CHECK(contains(stl(binary_stl(3, 0)), "claims 0 triangles, but 150 bytes follow"));
    CHECK(contains(stl(binary_stl(3, 4)), "claims 4 triangles, the file holds 3"));
    CHECK(contains(stl(good + "x"), "but 1 bytes follow"));
    const std::string with_lf = binary_stl(10, 10);  // the count is a line feed
    REQUIRE(contains(with_lf, "\n"));
    CHECK(contains(stl(replaced(with_lf, "\n", "\r\n")), "copied as text"));
  }
  SECTION("files of other kinds are named") {
    const std::string rest(200, '\1');
    CHECK(contains(stl("\x7F"
                       "ELF" +
                       rest),
                   "a program"));
    CHECK(contains(stl("PK\x03\x04" + rest), "a ZIP archive"));
    CHECK(contains(stl("\x1F\x8B" + rest), "gzip"));
    CHECK(contains(stl("<!DOCTYPE html><html>" + rest), "a web page"));
    std::string tar(600, '\0');
    tar.replace(0, 5, "a.stl").replace(257, 5, "ustar");
    CHECK(contains(stl(tar), "a TAR archive"));
    std::string wide;
    for (const char c : "solid a\nfacet normal 0 0 1\nouter loop\n"s) wide += {c, '\0'};
    CHECK(contains(stl(wide), "UTF-16"));
    CHECK(contains(said(MeshFormat::kOff, "\0" + wide), "UTF-16"));
    CHECK(contains(stl("\n <HTML>" + rest), "a web page"));
    CHECK(contains(stl("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"), "Git LFS"));
    CHECK(contains(stl("ISO-10303-21;\nHEADER;\n" + rest), "a STEP file"));
    CHECK(contains(stl(std::string(300, 'x')), "neither text that begins with 'solid' nor"));
    CHECK(contains(said(MeshFormat::kOff, "\x1F\x8B" + rest), "gzip"));
    CHECK(contains(said(MeshFormat::kObj, "PK\x03\x04" + rest), "a ZIP archive"));
  }
}

TEST_CASE("what stands behind all that the header counts is reported", "[loss]") {
  CHECK(said(MeshFormat::kOff, kOff) == "");
  CHECK(said(MeshFormat::kOff, kOff + "\n \n# the end\n") == "");
  CHECK(said(MeshFormat::kOff, kOff + "3 0 1 2\n") == "left out: 7 bytes of data behind the last face (line 7)");
  CHECK(contains(said(MeshFormat::kOff, kOff + "\n" + kOff), "(line 8)"));
  CHECK(said(MeshFormat::kOff, kOff + "\0\0"s) == "there are 2 bytes of padding at the end");
  CHECK(said(MeshFormat::kPly, kPly) == "");
  CHECK(said(MeshFormat::kPly, kPly + "\n\n") == "");
  CHECK(contains(said(MeshFormat::kPly, kPly + "3 0 1 2\n"), "7 bytes of data behind"));
  CHECK(said(MeshFormat::kPly, binary_ply()) == "");
  CHECK(contains(said(MeshFormat::kPly, binary_ply() + "\n"), "1 byte of padding"));
  CHECK(contains(said(MeshFormat::kPly, binary_ply() + "\3abc"), "4 bytes of data behind"));
  std::string with_lf = binary_ply();  // whose last coordinate holds a line feed
  with_lf.replace(with_lf.size() - 17, 4, raw_bytes(std::bit_cast<float>(0x3F8A0A01)));
  CHECK(said(MeshFormat::kPly, with_lf) == "");
  CHECK(contains(said(MeshFormat::kPly, replaced(with_lf, "\n", "\r\n")), "refused"));
  CHECK(contains(said(MeshFormat::kPly,
                      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                      "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                      "element trifan 2\nproperty list uchar int vertex_indices\nend_header\n" +
                          kVertices + "3 0 1 2\n3 0 1 2\n3 0 1 2\n"),
                 "2 statements that may be surface (the element 'trifan' in line 9)"));
}

TEST_CASE("OFF: what stands behind coordinates is numbers", "[loss]") {
  CHECK(said(MeshFormat::kOff, replaced(kOff, "1 0 0\n", "1 0 0 0.5 1e2 nan # red\n")) == "");
  CHECK(contains(said(MeshFormat::kOff, replaced(kOff, "1 0 0\n", "1 0 0 red\n")), "refused: m:line 4: "));
}

TEST_CASE("OFF in other layouts", "[loss]") {
  const auto off = [](const std::string& text) { return test::surface(read(MeshFormat::kOff, text).mesh); };
  for (const std::string& head : {"OFF\n3\n1\n0\n"s, "OFF\n3\n1 0\n"s, "OFF 3 1\n0\n"s, "OFF\n3 1\n"s, "off\n3 1 0\n"s,
                                  "Off 3 1 0\n"s, "3 1 0\n"s, "# no keyword\n3 1\n"s, "3\n1\n0\n"s}) {
    CAPTURE(head);
    CHECK(off(head + kVertices + "3 0 1 2\n") == 0.5);
    CHECK(said(MeshFormat::kOff, head + kVertices + "3 0 1 2\n") == "");
  }
  CHECK(off("coff\n3 1 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n3 0 1 2\n") == 0.5);
  CHECK(contains(said(MeshFormat::kOff, "noff\n3 1 0\n" + kVertices + "3 0 1 2\n"), "expected the keyword OFF"));
  CHECK(contains(said(MeshFormat::kOff, "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n"), "end of the line of counts"));
}

TEST_CASE("PLY elements over several lines", "[loss]") {
  const std::string head = "ply\nformat ascii 1.0\n" + kPlyHead;
  for (const std::string& body : {"0 0 0\n1 0\n0\n0\n1\n0\n3 0 1 2\n"s, "0 0 0\n1 0 0\n0 1 0\n3\n0 1\n2\n"s}) {
    CHECK(test::surface(read(MeshFormat::kPly, head + body).mesh) == 0.5);
    CHECK(said(MeshFormat::kPly, head + body) == "");
  }
  // Numbers must still add up, element by element.
  CHECK(contains(said(MeshFormat::kPly, head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "expected the end of the line"));
  CHECK(contains(said(MeshFormat::kPly, head + "0 0 0 1 0 0\n0 1 0\n3 0 1 2\n"), "expected the end of the line"));
}

TEST_CASE("OBJ: statements that are not known", "[loss]") {
  const auto obj = [](const std::string& text) { return said(MeshFormat::kObj, text); };
  CHECK(obj(kObj + "fo 1 2 3\n") == "");
  CHECK(obj("mtllib a.mtl\no a\ng b\ns off\nusemtl c\n" + kObj + "vt 0 0\nvn 0 0 1\nvp 1 2\nl 1 2\np 1\nf 1 2 3\n") ==
        "");
  CHECK(obj(kObj + "f 1 2 3\nsurf 0 1 0 1 1 2\nsurf 0 1 0 1/1 2/2 x\n") != "");
  CHECK(obj(kObj + "f 1 2 3\nsurf 0.0 1.0 0.0 1.0 1 2 3\nbzp 1 2 3 1 2 3\nbsp 1 2 3\ncdp 1 2 3\n") ==
        "left out: 4 statements that may be surface ('surf' in line 5)");
  CHECK(obj(kObj + "f 1 2 3\ncsh ls\nzap\ncsh\n") == "left out: 3 statements that may be surface ('csh' in line 5)");
  CHECK(contains(obj(kObj + "f 1 2 3\ncall other.obj\n"), "refused: m:line 5: the statement 'call'"));
  for (const char* wrong :
       {"V 0 0 1", "F 1 2 3", "0 0 1", "vertex 0 0 1", "v0 0 1", "face 1/1 2/2 3/3", "f1 2 3", "1//1 2//1 3//1",
        "w 1 2 3 4", "v,0,0,1", "v;0;0;1", "0,0,1", "vO 0 1", "vv0 0 1", "f,1,2,3", "fl 2 3", "f=1 2 3", "v[0] 0 1"}) {
    CAPTURE(wrong);
    CHECK(contains(obj(kObj + wrong + "\nf 1 2 3\n"), "refused: m:line 4: "));
  }
  CHECK(contains(obj("v 0 0 0 v 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n"), "refused: m:line 1: "));
  CHECK(contains(obj(kObj + "f 1 2 3\nf 1 2\n"), "1 face of fewer than three corners"));
  CHECK(
      contains(obj(kObj + "v nan 0 0\nf 1 2 3\nf 1 2 4\nf 4 2 1\n"), "2 faces with a coordinate that is not a finite"));
}

TEST_CASE("text STL in any layout", "[loss]") {
  const std::string usual =
      "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid a b\n";
  const std::string one_line =
      "solid a facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid a";
  for (const std::string& text :
       {usual, one_line, replaced(usual, "end", "end "), replaced(usual, "\nvertex", " vertex"),
        replaced(replaced(usual, "\nvertex 1", " 1"), "\nvertex 0 1", " 0 1"), replaced(usual, " ", "\t \t"),
        replaced(usual, "outer loop\n", "outer\nloop\n"), replaced(usual, "vertex 1 0 0", "vertex\n1\n0\n0"),
        replaced(usual, "normal 0 0 1", "normal nan -1.#IND x"), replaced(usual, " normal 0 0 1", ""),
        replaced(usual, "a b", "solid facet of stone"), replaced(usual, "solid a b", "solid"),
        replaced(usual, "a b", "solid"), "solid none\nendsolid none\n" + usual, "solid x endsolid x\n" + usual}) {
    CAPTURE(text);
    const LoadedMesh loaded = read(MeshFormat::kStl, text);
    CHECK(loaded.mesh.triangles.size() == 1);
    CHECK(test::surface(loaded.mesh) == 0.5);
    CHECK(summary(loaded.report) == "");
  }
  CHECK(read(MeshFormat::kStl, one_line + " " + one_line + "\n").mesh.triangles.size() == 2);
  CHECK(read(MeshFormat::kStl, one_line + "\n" + usual).mesh.triangles.size() == 2);
  for (const std::string& tail : {"\x1A"s, "\0\0\0"s, "\r\n\x1A\r\n"s}) {
    CHECK(test::surface(read(MeshFormat::kStl, usual + tail).mesh) == 0.5);
    CHECK(contains(said(MeshFormat::kStl, usual + tail), "of padding"));
  }
  const std::string four = replaced(usual, "endloop", "vertex 1 1 0\nendloop");
  CHECK(contains(said(MeshFormat::kStl, four), "1 facet of other than three corners"));
  CHECK(contains(said(MeshFormat::kStl, usual + replaced(usual, "vertex 1 0 0\n", "")), "1 face of fewer than three"));
  CHECK(contains(said(MeshFormat::kStl, replaced(usual, "vertex 1", "vertx 1")), "refused: m:line 5: "));
  // A facet of two loops is two polygons.
  const LoadedMesh loops =
      read(MeshFormat::kStl,
           replaced(usual, "endloop", "endloop\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendloop"));
  CHECK(test::surface(loops.mesh) == 1);
  CHECK(loops.mesh.triangles.size() == 2);
  CHECK(summary(read(MeshFormat::kStl, replaced(usual, "outer loop\n", "") + one_line).report) == "");
  // Text that something has damaged is not taken for binary data.
  CHECK(contains(said(MeshFormat::kStl, replaced(usual, "vertex 1", "vertex \0"s)),
                 "refused: m:line 5: a NUL character"));
  CHECK(
      contains(said(MeshFormat::kStl, replaced(usual, "solid a", "solid \0"s)), "refused: m:line 1: a NUL character"));
  CHECK(contains(said(MeshFormat::kStl, one_line + "\n\0"s + one_line), "refused: m:line 2: a NUL character"));
  CHECK(contains(said(MeshFormat::kStl, replaced(usual, "0 1 0", "0 1 0 9")), "refused"));
  CHECK(contains(said(MeshFormat::kStl, usual + "3 0 1 2\n"), "refused: m:line 10: expected solid"));
}

TEST_CASE("a long line of keywords takes no time", "[loss]") {
  std::string text = "solid";
  for (int i = 0; i < 300000; ++i) text += " solid";
  CHECK(contains(said(MeshFormat::kStl, text + "\n"), "refused"));
  CHECK(contains(said(MeshFormat::kStl, text + " facet\n"), "refused"));
  for (int i = 0; i < 300000; ++i) text += " endsolid solid facet";
  CHECK(contains(said(MeshFormat::kStl, text + "\n"), "refused"));
}

TEST_CASE("binary STL is written only where single precision keeps the mesh", "[loss]") {
  const Mesh cube = load_mesh("shape:box").mesh;
  const auto moved = [&](double scale, double offset) {
    Mesh mesh = cube;
    for (Vector3& v : mesh.vertices) v = scale * v + Vector3::Constant(offset);
    return mesh;
  };
  const auto written = [](const Mesh& mesh, bool recentre = false) {
    return read(MeshFormat::kStl, mesh_bytes(mesh, MeshFormat::kStl, {.binary = true, .recentre = recentre}, "m.stl"))
        .mesh;
  };
  CHECK(test::surface(written(cube)) == Approx(6));
  CHECK(test::surface(written(moved(1e15, 0))) == Approx(6e30));
  CHECK(test::surface(written(moved(1e-15, 0))) == Approx(6e-30));
  CHECK_THROWS_WITH(written(moved(1.3, 4.5e6)), Catch::Contains("single precision") && Catch::Contains("--recentre"));
  CHECK_THROWS_WITH(written(moved(1e-50, 0)), Catch::Contains("single precision"));
  CHECK_THROWS_WITH(written(moved(1e-44, 0)), Catch::Contains("single precision"));
  CHECK(test::surface(written(moved(1.3, 4.5e6), true)) == Approx(6 * 1.69).epsilon(1e-6));
  CHECK_THROWS_AS(written(moved(1e-50, 0), true), MeshError);
  // Text and doubles hold anything.
  CHECK(mesh_bytes(moved(1e-50, 0), MeshFormat::kStl, {.binary = false}, "m.stl").starts_with("solid"));
  CHECK_NOTHROW(mesh_bytes(moved(1, 4.5e6), MeshFormat::kPly, {}, "m.ply"));
}

TEST_CASE("lists of sources", "[loss]") {
  const auto list = [](const std::string& text) { return sources_in_list(text, "list"); };
  using Names = std::vector<std::string>;
  CHECK(list("").empty());
  CHECK(list("a\nb c\r\n\n d") == Names{"a", "b c", " d"});
  CHECK(list("\xEF\xBB\xBF"
             "a\nb\n") == Names{"a", "b"});
  CHECK(list("a\0b\nc\0"s) == Names{"a", "b\nc"});
  CHECK(list("a\0"s) == Names{"a"});
  CHECK(list("solid state.off\nb\n") == Names{"solid state.off", "b"});
  CHECK(list("off\nb\n") == Names{"off", "b"});
  for (const std::string& mesh : {kOff, kPly, "solid a\nfacet normal 0 0 1\n"s}) CHECK_THROWS_AS(list(mesh), MeshError);
  for (const std::string& wrong : {"\0\n"s, "\0"s, "a\0b"s, "a\0\0b\0"s,
                                   "\xFF\xFE"
                                   "a\0\n\0"s,
                                   "\xFE\xFF\0a\0\n"s, "a\0.\0o\0\n\0"s, "\0a\0\n"s, "a\0b\n"s}) {
    CHECK_THROWS_AS(list(wrong), MeshError);
  }
}
