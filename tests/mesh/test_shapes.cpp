// Shapes: closed forms for volumes and areas, topology, determinism, settings.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "rectilin/mesh/shapes.h"
#include "support/catch.h"
#include "support/surface.h"

namespace rectilin {
namespace {

using std::numbers::pi;

/// For sums of a few thousand terms of order one.
constexpr double kRounding = 1e-11;

Mesh shape(const std::string& text) { return make_shape(Spec::parse(text)); }

Vector3 area_vector(const Mesh& mesh, const Triangle& t) {
  const auto& v = mesh.vertices;
  return 0.5 * (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]);
}

/// By the divergence theorem; positive if the triangles face outward.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area_vector(mesh, t).dot(mesh.vertices[t[0]]) / 3;
  return sum;
}

Vector3 extents(const Mesh& mesh) {
  Vector3 lower = mesh.vertices.front(), upper = lower;
  for (const auto& p : mesh.vertices) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return upper - lower;
}

/// Every directed edge once, and its reverse too: closed, manifold along edges, oriented.
bool is_watertight(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (!edges.insert({t[i], t[(i + 1) % 3]}).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return edges.count({e.second, e.first}) == 1; });
}

/// V - E + F of a closed mesh, every vertex being in use.
long euler_characteristic(const Mesh& mesh) {
  std::set<std::uint32_t> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  REQUIRE(used.size() == mesh.vertices.size());
  return static_cast<long>(used.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

bool has_axis_parallel_faces(const Mesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Vector3 v = area_vector(mesh, t).cwiseAbs();
    return v.sum() - v.maxCoeff() <= 1e-12 * v.maxCoeff();
  });
}

std::string error_of(const std::string& text) {
  try {
    shape(text);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "no error";
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool same_bits(const Mesh& a, const Mesh& b) { return a.vertices == b.vertices && a.triangles == b.triangles; }

/// The errors of a sequence of shapes, each twice as fine as the one before, fall by a factor of
/// four.
void check_second_order(const std::vector<Mesh>& meshes, double (*value)(const Mesh&), double limit) {
  std::vector<double> errors;
  for (const auto& mesh : meshes) errors.push_back(std::abs(value(mesh) - limit));
  for (std::size_t i = 1; i < errors.size(); ++i) {
    CHECK(errors[i - 1] / errors[i] > 3.5);  // 4 but for terms of higher order
    CHECK(errors[i - 1] / errors[i] < 4.5);
  }
  CHECK(errors.back() < 0.01 * limit);
}

const std::vector<std::string> kClosed{"box",
                                       "box?x=2&y=0.5&faces=1000",
                                       "box?x=1000&y=0.001&faces=100",
                                       "lshape",
                                       "lshape?notch=0.9",
                                       "stairs",
                                       "stairs?steps=1",
                                       "stairs?steps=37",
                                       "stepped-pyramid",
                                       "stepped-pyramid?steps=1",
                                       "stepped-pyramid?steps=50",
                                       "pyramid",
                                       "prism",
                                       "prism?sides=3",
                                       "cylinder",
                                       "cut-cube",
                                       "cut-cube?depth=0",
                                       "cut-cube?depth=0.001",
                                       "cut-cube?depth=0.3333333333333333",
                                       "cut-cube?depth=0.5",
                                       "cut-cube?depth=0.9",
                                       "cut-cube?direction=0,0,-1&depth=0.5",
                                       "cut-cube?direction=0,0,1&depth=0",
                                       "cut-cube?direction=1,-1,0&depth=0.5",
                                       "cut-cube?direction=1,1,0&depth=0.25",
                                       "cut-cube?direction=3,2,1&depth=0.4",
                                       "filleted-cube",
                                       "filleted-cube?radius=0",
                                       "filleted-cube?radius=0.5&segments=3",
                                       "filleted-cube?segments=1",
                                       "sphere",
                                       "sphere?subdivisions=0",
                                       "sphere?subdivisions=1",
                                       "sphere?kind=latlong",
                                       "sphere?kind=latlong&slices=3&stacks=2",
                                       "sphere?kind=even&faces=1001",
                                       "ellipsoid",
                                       "ellipsoid?a=5&kind=octahedral&subdivisions=3",
                                       "torus",
                                       "torus?slices=3&stacks=3",
                                       "blob",
                                       "blob?faces=501&seed=9&amplitude=1&waves=3"};

}  // namespace

TEST_CASE("closed shapes are watertight, face outward and have no empty triangle", "[shapes]") {
  for (const auto& text : kClosed) {
    INFO(text);
    const Mesh mesh = shape(text);
    CHECK(is_watertight(mesh));
    CHECK(euler_characteristic(mesh) == (text.starts_with("torus") ? 0 : 2));
    CHECK(volume(mesh) > 0);
    Vector3 sum = Vector3::Zero();
    double smallest = test::surface(mesh);
    for (const auto& t : mesh.triangles) {
      sum += area_vector(mesh, t);
      smallest = std::min(smallest, area_vector(mesh, t).norm());
    }
    CHECK(smallest > 0);
    CHECK(sum.norm() < kRounding * test::surface(mesh));
  }
}

TEST_CASE("spheres of any size and kind are closed, convex and well formed", "[shapes]") {
  std::vector<std::string> texts{"sphere?subdivisions=0", "sphere?subdivisions=4",
                                 "sphere?kind=latlong&slices=7&stacks=5"};
  for (int faces = 8; faces < 300; ++faces) texts.push_back("sphere?kind=even&faces=" + std::to_string(faces));
  texts.push_back("sphere?kind=even&faces=20000");
  for (const auto& text : texts) {
    INFO(text);
    const Mesh mesh = shape(text);
    CHECK(is_watertight(mesh));
    CHECK(euler_characteristic(mesh) == 2);
    CHECK(std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                      [&](const Triangle& t) { return area_vector(mesh, t).dot(mesh.vertices[t[0]]) > 0; }));
    CHECK(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                      [](const Vector3& p) { return std::abs(p.norm() - 1) < 1e-14; }));
  }
}

TEST_CASE("the octahedral sphere keeps the octahedron's symmetries", "[shapes]") {
  const Mesh mesh = shape("sphere?subdivisions=3");
  const auto key = [](const Vector3& p) {
    return std::array{std::lround(p.x() * 1e9), std::lround(p.y() * 1e9), std::lround(p.z() * 1e9)};
  };
  const auto triangle_keys = [&](const Eigen::Matrix3d& map) {
    std::set<std::set<std::array<long, 3>>> keys;
    for (const auto& t : mesh.triangles)
      keys.insert({key(map * mesh.vertices[t[0]]), key(map * mesh.vertices[t[1]]), key(map * mesh.vertices[t[2]])});
    return keys;
  };
  Eigen::Matrix3d cyclic, mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal(), exchange;
  cyclic << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  exchange << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  const auto before = triangle_keys(Eigen::Matrix3d::Identity());
  CHECK(before.size() == 512);
  CHECK(triangle_keys(cyclic) == before);
  CHECK(triangle_keys(mirror) == before);
  CHECK(triangle_keys(exchange) == before);
}

TEST_CASE("solids with flat sides have their exact volumes and areas", "[shapes]") {
  struct Known {
    std::string text;
    double volume, area;
  };
  const double pyramid_slope = std::sqrt(1.5 * 1.5 + 1);  // of a side's triangle: base 2, height 1.5
  const double hexagon = 1.5 * std::sqrt(3.0);            // of radius 1
  const std::vector<Known> all{
      {"box?x=1&y=2&z=3", 6, 22},
      {"box?x=1&y=2&z=3&faces=5000", 6, 22},
      {"pyramid?base=2&height=1.5", 2, 4 + 4 * pyramid_slope},
      {"prism?sides=6&radius=1&height=2", 2 * hexagon, 2 * hexagon + 12},
      {"prism?sides=6&radius=1&height=2&scale=0.5", hexagon / 4, (2 * hexagon + 12) / 4},
      {"lshape?x=2&y=3&z=5&notch=0.5", 22.5, 2 * 4.5 + 10 * 5},
      // Profile of 1 + 2 + 3 blocks of 2 x 1 and a perimeter like its bounding rectangle's.
      {"stairs?x=4&y=6&z=3&steps=3", 4 * 12, 2 * 12 + 4 * 18},
      // Squares of sides 6, 4, 2, each 1 high; what is seen from above and below is the base.
      {"stepped-pyramid?base=6&height=3&steps=3", 36 + 16 + 4, 2 * 36 + 4 * (6 + 4 + 2)},
      {"cut-cube?depth=0", 1, 6},
      // A corner cut off along the diagonals of three sides.
      {"cut-cube?depth=0.3333333333333333", 5.0 / 6, 6 - 1.5 + std::sqrt(3.0) / 2},
      // Half the cube; the cut is the regular hexagon with edges 1/sqrt(2).
      {"cut-cube?depth=0.5", 0.5, 3 + hexagon / 2},
      {"cut-cube?direction=0,2,0&depth=0.25", 0.75, 2 + 4 * 0.75},
      {"cut-cube?direction=-1,0,1&depth=0.5", 0.5, 2 + 1 + std::sqrt(2.0)},
      {"filleted-cube?radius=0", 1, 6},
  };
  for (const auto& known : all) {
    INFO(known.text);
    const Mesh mesh = shape(known.text);
    CHECK(volume(mesh) == Approx(known.volume).epsilon(kRounding));
    CHECK(test::surface(mesh) == Approx(known.area).epsilon(kRounding));
  }
}

TEST_CASE("round shapes converge at second order", "[shapes]") {
  const auto refined = [](const std::string& text, const std::vector<std::string>& finenesses) {
    std::vector<Mesh> meshes;
    for (const auto& fineness : finenesses) meshes.push_back(shape(text + fineness));
    return meshes;
  };
  const std::vector<std::string> latlong{"&slices=32&stacks=16", "&slices=64&stacks=32", "&slices=128&stacks=64"};
  const std::vector<std::string> even{"&faces=1000", "&faces=4000", "&faces=16000"};
  const std::vector<std::string> octahedral{"&subdivisions=3", "&subdivisions=4", "&subdivisions=5"};

  for (const auto& meshes : {refined("sphere?radius=2", octahedral), refined("sphere?radius=2&kind=latlong", latlong),
                             refined("sphere?radius=2&kind=even", even)}) {
    check_second_order(meshes, volume, 32 * pi / 3);
    check_second_order(meshes, test::surface, 16 * pi);
  }
  const double e = std::sqrt(0.75);  // eccentricity of the prolate spheroid of semi-axes 2, 1, 1
  const auto spheroids = refined("ellipsoid?a=2&b=1&c=1", even);
  check_second_order(spheroids, volume, 8 * pi / 3);
  check_second_order(spheroids, test::surface, 2 * pi * (1 + 2 / e * std::asin(e)));

  const auto tori = refined("torus?major=2&minor=0.5", latlong);
  check_second_order(tori, volume, 2 * pi * pi * 2 * 0.25);
  check_second_order(tori, test::surface, 4 * pi * pi * 2 * 0.5);

  // A cube, its core of edge c grown by r (Steiner's formula).
  const double r = 0.2, c = 1 - 2 * r;
  const auto cubes = refined("filleted-cube?radius=0.2", {"&segments=4", "&segments=8", "&segments=16"});
  check_second_order(cubes, volume, c * c * c + 6 * c * c * r + 3 * c * pi * r * r + 4 * pi / 3 * r * r * r);
  check_second_order(cubes, test::surface, 6 * c * c + 6 * c * pi * r + 4 * pi * r * r);

  const auto cylinders = refined("cylinder?radius=1", {"&sides=16", "&sides=32", "&sides=64"});
  check_second_order(cylinders, volume, pi);
  check_second_order(cylinders, test::surface, 4 * pi);
}

TEST_CASE("a fully filleted cube is a sphere and keeps the cube's extents", "[shapes]") {
  for (const auto& p : shape("filleted-cube?radius=0.5").vertices) CHECK(p.norm() == Approx(0.5).epsilon(1e-14));
  for (const auto& text : {"filleted-cube?radius=0.1", "filleted-cube?radius=0.5", "filleted-cube?radius=0"})
    CHECK((extents(shape(text)) - Vector3::Ones()).norm() < 1e-14);
}

TEST_CASE("rectilinear solids have axis-parallel faces only", "[shapes]") {
  for (const auto& text : {"box?x=3&faces=300", "lshape?notch=0.3", "stairs?steps=7", "filleted-cube?radius=0",
                           "stepped-pyramid?steps=9", "cut-cube?direction=1,0,0"})
    CHECK(has_axis_parallel_faces(shape(text)));
  CHECK_FALSE(has_axis_parallel_faces(shape("pyramid")));
}

TEST_CASE("shapes have as many faces as asked", "[shapes]") {
  CHECK(shape("box").triangles.size() == 12);
  CHECK(shape("box?x=1000&y=0.001&z=0.001").triangles.size() == 12);
  for (const std::size_t faces : {1000, 30'000, 200'000}) {
    const std::string asked = "faces=" + std::to_string(faces);
    const std::size_t box = shape("box?y=2&" + asked).triangles.size();
    CHECK(box <= faces);
    CHECK(box > faces * 4 / 5);
    for (const std::string name : {"blob", "ellipsoid", "soup"})
      CHECK(shape(name + "?" + asked).triangles.size() == faces);
  }
  CHECK(shape("blob?faces=2001").triangles.size() == 2000);
  CHECK(shape("sphere?subdivisions=3").triangles.size() == 512);
  CHECK(shape("sphere?kind=latlong&slices=10&stacks=4").triangles.size() == 60);
}

TEST_CASE("an open cylinder lacks its ends", "[shapes]") {
  const Mesh mesh = shape("cylinder?caps=false");
  CHECK_FALSE(is_watertight(mesh));
  CHECK(mesh.triangles.size() == 128);
}

TEST_CASE("the same spec gives the same bits, another seed another shape", "[shapes]") {
  for (const std::string text :
       {"blob?faces=500", "soup?faces=50", "box?noise=0.1", "box?rotate=random", "lshape?noise=0.01&rotate=random"}) {
    INFO(text);
    const auto with = [&](const std::string& settings) { return shape(text + "&" + settings); };
    CHECK(same_bits(with("seed=5"), with("seed=5")));
    CHECK_FALSE(same_bits(with("seed=5"), with("seed=6")));
  }
  CHECK(same_bits(shape("torus?seed=5"), shape("torus?seed=6")));
}

TEST_CASE("noise moves vertices by the deviation asked for", "[shapes]") {
  const Mesh calm = shape("box?x=4&faces=20000"), noisy = shape("box?x=4&faces=20000&noise=0.01");
  REQUIRE(noisy.triangles == calm.triangles);
  CHECK(is_watertight(noisy));
  double squares = 0;
  for (std::size_t i = 0; i < calm.vertices.size(); ++i)
    squares += (noisy.vertices[i] - calm.vertices[i]).squaredNorm();
  const double deviation = std::sqrt(squares / (3 * static_cast<double>(calm.vertices.size())));
  CHECK(deviation == Approx(0.04).epsilon(0.03));  // 30,000 samples: five standard errors are 0.02
}

TEST_CASE("rotate turns the shape by a proper rotation", "[shapes]") {
  const Mesh still = shape("lshape");
  const auto map_to = [&](const Mesh& turned) -> Eigen::Matrix3d {
    // The corners 1, 5 and 6 of an L with unit extents lie on the x, y and z axis.
    Eigen::Matrix3d from, to;
    from << still.vertices[1], still.vertices[5], still.vertices[6];
    to << turned.vertices[1], turned.vertices[5], turned.vertices[6];
    return to * from.inverse();
  };
  for (const std::string setting : {"random", "0.3,-2,1e-1"}) {
    INFO(setting);
    const Mesh turned = shape("lshape?seed=3&rotate=" + setting);
    const Eigen::Matrix3d map = map_to(turned);
    CHECK((map * map.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(map.determinant() == Approx(1));
    for (std::size_t i = 0; i < still.vertices.size(); ++i)
      CHECK((turned.vertices[i] - map * still.vertices[i]).norm() < 1e-14);
  }
  // Eqs. (35)-(37) with gamma alone: x' = x cos + y sin, y' = -x sin + y cos.
  const Eigen::Matrix3d quarter = map_to(shape("lshape?rotate=0,0,1.5707963267948966"));
  CHECK((quarter * Vector3(1, 0, 0) - Vector3(0, -1, 0)).norm() < 1e-15);
  // With alpha alone: z' = -y sin + z cos.
  const Eigen::Matrix3d alpha = map_to(shape("lshape?rotate=1.5707963267948966,0,0"));
  CHECK((alpha * Vector3(0, 1, 0) - Vector3(0, 0, -1)).norm() < 1e-15);
}

TEST_CASE("every listed shape is made by its name, with defaults as described", "[shapes]") {
  std::set<std::string> names;
  for (const auto& info : shape_table().entries()) {
    INFO(info.name);
    CHECK(names.insert(info.name).second);
    CHECK_FALSE(info.help.empty());
    const Mesh mesh = shape(info.name);
    CHECK(test::surface(mesh) > 0);
    CHECK(std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                      [&](const Triangle& t) { return *std::max_element(t.begin(), t.end()) < mesh.vertices.size(); }));
    CHECK(std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vector3& p) { return p.allFinite(); }));
    Spec spec{info.name};
    for (const auto& parameter : info.parameters) spec.settings[parameter.name] = parameter.value;
    CHECK(same_bits(make_shape(spec), mesh));
  }
  for (const std::string name : {"box", "pyramid", "sphere", "cylinder", "ellipsoid", "torus", "lshape", "stairs",
                                 "cut-cube", "filleted-cube", "stepped-pyramid", "blob", "soup"})
    CHECK(names.count(name) == 1);
}

TEST_CASE("wrong names, settings and values are named in the error", "[shapes]") {
  CHECK(mentions(error_of("cube"), "no shape 'cube'"));
  CHECK(mentions(error_of("cube"), "filleted-cube"));
  CHECK(mentions(error_of("box?w=1"), "box: no parameter 'w'"));
  CHECK(mentions(error_of("box?faces=1e12"), "faces"));
  CHECK(mentions(error_of("box?faces=11"), "faces"));
  CHECK(mentions(error_of("box?x=0"), "x=0"));
  CHECK(mentions(error_of("box?x=-1"), "x=-1"));
  CHECK(mentions(error_of("box?noise=nan"), "noise"));
  CHECK(mentions(error_of("box?rotate=1,2"), "rotate"));
  CHECK(mentions(error_of("box?rotate=1,2,3,4"), "rotate"));
  CHECK(mentions(error_of("box?rotate=\xff"), "rotate"));
  CHECK(mentions(error_of("sphere?subdivisions=12"), "subdivisions"));
  CHECK(mentions(error_of("sphere?faces=100"), "sphere: faces is a setting of kind=even"));
  CHECK(mentions(error_of("ellipsoid?slices=9"), "ellipsoid: slices"));
  CHECK(mentions(error_of("torus?minor=2"), "torus: minor"));
  CHECK(mentions(error_of("cut-cube?direction=0,0,0"), "cut-cube: direction"));
  CHECK(mentions(error_of("cut-cube?depth=1"), "depth"));
}

}  // namespace rectilin
