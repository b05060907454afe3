// What every descriptor promises: zero for equal models, symmetry, invariance, its length; texts that make them.
#include <cmath>

#include "rectilin/base/random.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/descriptor.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;
using namespace rectilin::retrieval;

namespace {

Mesh moved(const Mesh& mesh, const Rotation& rotation, double scale, const Vector3& shift) {
  return test::transformed(mesh, [&](const Vector3& v) -> Vector3 { return scale * (rotation.matrix() * v) + shift; });
}

/// Shapes without symmetry, so that poses are unique but for the 24 rotations.
std::vector<Mesh> zoo() {
  std::vector<Mesh> meshes;
  for (const char* spec :
       {"shape:lshape", "shape:stairs", "shape:blob", "shape:pyramid", "shape:torus", "shape:box?x=3&y=2"})
    meshes.push_back(load_mesh(spec).mesh);
  return meshes;
}

std::string small(const std::string& name) {
  if (name == "gsmd") return "gsmd?views=6&size=128";
  return name.starts_with("lfd") ? name + "?size=64" : name;
}

}  // namespace

TEST_CASE("Every descriptor has its length, is zero for equal models and symmetric, and stays within 0 and 1") {
  const std::vector<Mesh> meshes = zoo();
  for (const auto& entry : descriptors().entries()) {
    INFO(entry.name);
    const DescriptorPointer descriptor = make_descriptor(small(entry.name));
    std::vector<Signature> signatures;
    for (const Mesh& mesh : meshes) {
      const Model model(mesh);
      signatures.push_back(descriptor->describe(model));
      CHECK(signatures.back().size() == descriptor->bytes());
      CHECK(descriptor->describe(model) == signatures.back());
    }
    for (const Signature& a : signatures)
      for (const Signature& b : signatures) {
        const double d = descriptor->distance(a, b);
        CHECK(d == descriptor->distance(b, a));
        CHECK(d >= 0);
        if (entry.name != "best") CHECK(d <= 1);  // a sum
        if (&a == &b) CHECK(d == 0);
      }
    CHECK_FALSE(descriptor->distance_in_words().empty());
    CHECK_FALSE(descriptor->invariant_to().empty());
  }
}

TEST_CASE("A model in another rotation, scale and position finds itself first") {
  const std::vector<Mesh> meshes = zoo();
  Random random(4);
  for (const char* name : {"d1", "d2", "aad", "sprh", "shd", "gsmd", "lfd", "swc", "dla"}) {
    INFO(name);
    const DescriptorPointer descriptor = make_descriptor(small(name));
    std::vector<Signature> database;
    for (const Mesh& mesh : meshes) database.push_back(descriptor->describe(Model(mesh)));
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const Mesh turned = moved(meshes[i], random_rotation(random), std::pow(10, random.uniform(-3, 3)),
                                {random.normal(), random.normal(), random.normal()});
      const Signature query = descriptor->describe(Model(turned));
      std::size_t nearest = 0;
      for (std::size_t k = 1; k < database.size(); ++k)
        if (descriptor->distance(query, database[k]) < descriptor->distance(query, database[nearest])) nearest = k;
      CHECK(nearest == i);
    }
  }
}

TEST_CASE("The 24 rotations of a frame are next to nothing apart") {
  const Mesh mesh = load_mesh("shape:stairs").mesh, other = load_mesh("shape:lshape").mesh;
  for (const char* spec : {"gsmd?pose=none&views=18&size=128", "gsmd?pose=none&views=6&image=silhouette&size=128",
                           "shd?pose=none", "swc?pose=none"}) {
    INFO(spec);
    const DescriptorPointer descriptor = make_descriptor(spec);
    const Signature base = descriptor->describe(Model(mesh));
    const double apart = descriptor->distance(base, descriptor->describe(Model(other)));
    for (const Rotation& d : frame_symmetries()) {
      const Signature turned = descriptor->describe(Model(moved(mesh, d, 1, Vector3::Zero())));
      CHECK(descriptor->distance(base, turned) < 0.02 * apart + 1e-6);
    }
  }
}

TEST_CASE("Matching one way only sees the rotations that matching all ways forgives") {
  const Mesh mesh = load_mesh("shape:stairs").mesh;
  const Mesh turned = moved(mesh, rotation_from_euler(std::acos(0.0), 0, 0), 1, Vector3::Zero());
  const auto distance = [&](const std::string& match) {
    const DescriptorPointer d = make_descriptor("gsmd?pose=none&views=6&size=128&match=" + match);
    return d->distance(d->describe(Model(mesh)), d->describe(Model(turned)));
  };
  CHECK(distance("one") > 10 * distance("all"));
  CHECK(distance("one") >= distance("turns"));
  CHECK(distance("turns") >= distance("all"));
}

TEST_CASE("A weighted sum is the weighted mean of its terms") {
  const Model a(load_mesh("shape:box").mesh), b(load_mesh("shape:torus").mesh);
  const auto distance = [&](const std::string& text) {
    const DescriptorPointer d = make_descriptor(text);
    return d->distance(d->describe(a), d->describe(b));
  };
  const auto scaled = [&](const std::string& text) {
    return distance(text) / make_descriptor(text)->typical_distance();
  };
  CHECK(distance("d2+0.5*r") == Approx((scaled("d2") + 0.5 * scaled("r")) / 1.5));
  CHECK(distance("7*d2") == distance("d2"));
  CHECK(make_descriptor("d2?bins=8+r")->bytes() == 4 * 8 + 4);
  const auto terms = parse_composite("d2?bins=8+0.25*r");
  REQUIRE(terms.size() == 2);
  CHECK(terms[0].spec == "d2?bins=8");
  CHECK(terms[1].weight == 0.25);
}

TEST_CASE("Texts that make no descriptor say why") {
  CHECK_THROWS_WITH(make_descriptor("gsmt"), Catch::Contains("no descriptor 'gsmt'; did you mean 'gsmd'?"));
  CHECK_THROWS_WITH(make_descriptor("d2+"), "'d2+': a term without a descriptor");
  CHECK_THROWS_WITH(make_descriptor("0*d2"), "'0*d2': '0' is not a positive weight");
  CHECK_THROWS_WITH(make_descriptor("x*d2"), "'x*d2': 'x' is not a positive weight");
  CHECK_THROWS_WITH(make_descriptor("gsmd?views=7"), Catch::Contains("views=7 is not accepted (6 | 18 | 66 | 258)"));
}

TEST_CASE("A mesh without area is refused and coordinates of any size are not") {
  Mesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  for (const char* name : {"d1", "d2", "aad", "sprh"})
    CHECK_THROWS_AS(make_descriptor(name)->describe(Model(flat)), MeshError);
  const Mesh box = load_mesh("shape:box?x=3&y=2").mesh;
  for (const char* name : {"d2", "shd", "gsmd"}) {
    INFO(name);
    const DescriptorPointer d = make_descriptor(small(name));
    const Signature base = d->describe(Model(box));
    for (const double scale : {1e-150, 1e150})
      CHECK(d->distance(base, d->describe(Model(moved(box, Rotation(), scale, Vector3::Zero())))) < 1e-3);
  }
}
