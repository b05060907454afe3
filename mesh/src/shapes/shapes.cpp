#include "rectilin/mesh/shapes.h"

#include <array>
#include <functional>
#include <utility>

#include "rectilin/base/random.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/edits.h"
#include "shapes/random_shapes.h"
#include "shapes/round.h"
#include "shapes/solids.h"

namespace rectilin {
namespace {

/// Streams of random numbers, one for each use, so that no setting changes what another one draws.
enum Stream : std::uint64_t { kShapeStream, kRotationStream, kNoiseStream };

/// What every shape accepts besides its own settings; done in the order noise, rotation, scale.
struct Finish {
  double noise = 0;
  std::string rotate = "none";
  std::array<double, 3> angles{};  ///< of `rotate` when it is neither "none" nor "random"
  double scale = 1;
  std::uint64_t seed = 1;

  void bind(Parameters& parameters) {
    parameters
        .custom(
            "rotate", "none | random | a,b,c", [this](const Json& value) { return set_rotate(value); },
            [this] { return Json(rotate); },
            "none, uniformly random by the seed, or three Euler angles in radians (eqs. 35-37)")
        .real("noise", noise, 0, 10, "standard deviation of each vertex coordinate's displacement, in largest extents")
        .real("scale", scale, 1e-100, 1e100, "factor for all lengths, last of all")
        .seed("seed", seed, "seed of the shape's, the rotation's and the noise's random numbers");
  }

  void apply(Mesh& mesh) const {
    if (noise > 0) mesh = with_noise(std::move(mesh), noise, Random(seed).fork(kNoiseStream));
    if (rotate == "none" && scale == 1) return;
    const Eigen::Matrix3d map = scale * rotation();
    for (auto& p : mesh.vertices) p = map * p;
  }

 private:
  bool set_rotate(const Json& value) {
    if (value != "none" && value != "random" && !read_vector3(value, angles, -1000, 1000)) return false;
    rotate = value.get<std::string>();
    return true;
  }

  Eigen::Matrix3d rotation() const {
    if (rotate == "none") return Eigen::Matrix3d::Identity();
    if (rotate != "random") return rotation_from_euler(angles[0], angles[1], angles[2]).matrix();
    Random random = Random(seed).fork(kRotationStream);
    return random_rotation(random).matrix();
  }
};

struct Maker {
  std::string name, help;
  std::function<Mesh(const Json& settings)> make;
  std::function<std::vector<Parameters::Description>()> describe;
};

/// An options struct with its finish, bound together.
template <class Shape>
struct Finished {
  Shape shape;
  Finish finish;
  Parameters parameters;

  Finished() {
    shape.bind(parameters);
    finish.bind(parameters);
  }
  Finished(const Finished&) = delete;  // the parameters point into it

  Mesh build() const {
    if constexpr (requires { shape.build(); }) {
      return shape.build();
    } else {
      Random random = Random(finish.seed).fork(kShapeStream);
      return shape.build(random);
    }
  }
};

template <class Shape>
Maker maker(const std::string& name, std::string help) {
  const auto make = [name](const Json& settings) {
    Finished<Shape> finished;
    finished.parameters.set(settings, name);
    try {
      Mesh mesh = finished.build();
      finished.finish.apply(mesh);
      return mesh;
    } catch (const ParameterError& error) {
      throw ParameterError(name + ": " + error.what());
    }
  };
  return {name, std::move(help), make, [] { return Finished<Shape>().parameters.describe(); }};
}

const std::vector<Maker>& makers() {
  using namespace shapes;
  static const std::vector<Maker> all{
      maker<Box>("box", "box about the origin, rectilinear"),
      maker<LShape>("lshape", "L-shaped solid, rectilinear"),
      maker<Stairs>("stairs", "solid flight of stairs, rectilinear"),
      maker<SteppedPyramid>("stepped-pyramid", "square pyramid of steps, rectilinear (Fig. 15)"),
      maker<Pyramid>("pyramid", "square pyramid"),
      maker<Prism>("prism", "regular prism"),
      maker<Cylinder>("cylinder", "circular cylinder: a regular prism of many sides"),
      maker<CutCube>("cut-cube", "unit cube with a part cut off by a plane (Fig. 8)"),
      maker<FilletedCube>("filleted-cube", "unit cube with rounded edges and corners (Fig. 9)"),
      maker<Sphere>("sphere", "sphere"),
      maker<Ellipsoid>("ellipsoid", "ellipsoid (Fig. 10)"),
      maker<Torus>("torus", "torus about the z axis"),
      maker<Blob>("blob", "bumpy star-shaped surface of any number of faces, random"),
      maker<Soup>("soup", "loose random triangles"),
  };
  return all;
}

}  // namespace

Mesh make_shape(const Spec& spec) {
  for (const auto& maker : makers())
    if (maker.name == spec.name) return maker.make(spec.settings);
  std::string names;
  for (const auto& maker : makers()) names += (names.empty() ? "" : ", ") + maker.name;
  throw ParameterError("no shape '" + spec.name + "'; there are " + names);
}

std::vector<ShapeInfo> list_shapes() {
  std::vector<ShapeInfo> list;
  for (const auto& maker : makers()) list.push_back({maker.name, maker.help, maker.describe()});
  return list;
}

}  // namespace rectilin
