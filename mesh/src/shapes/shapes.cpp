#include "rectilin/mesh/shapes.h"

#include <array>
#include <utility>

#include "rectilin/base/random.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/edits.h"
#include "shapes/random_shapes.h"
#include "shapes/round.h"
#include "shapes/solids.h"

namespace rectilin {
namespace {

/// Separate streams of random numbers for each use, so that no setting changes what another one draws.
enum Stream : std::uint64_t { kShapeStream, kRotationStream, kNoiseStream };

/// The settings that every shape accepts besides its own. They are applied in the order noise, rotation, scale.
struct Finish {
  double noise = 0;
  std::string rotate = "none";
  std::array<double, 3> angles{};  ///< Euler angles, if `rotate` is neither "none" nor "random"
  double scale = 1;
  std::uint64_t seed = 1;

  void bind(Parameters& parameters) {
    parameters
        .custom(
            "rotate", "none | random | a,b,c", [this](const Json& value) { return set_rotate(value); },
            [this] { return Json(rotate); },
            "none, random (by the seed), or three Euler angles in radians (eqs. 35-37)")
        .real("noise", noise, 0, 10,
              "standard deviation of each vertex coordinate's displacement, in longest sides of the box")
        .real("scale", scale, 1e-100, 1e100, "factor for all lengths, applied last")
        .seed("seed", seed, "seed of the random numbers for shape, rotation and noise");
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

/// A shape's own settings and those that all accept.
template <class Shape>
struct Finished {
  Shape shape;
  Finish finish;

  void bind(Parameters& parameters) {
    shape.bind(parameters);
    finish.bind(parameters);
  }

  Mesh build() const {
    Mesh mesh;
    if constexpr (requires { shape.build(); }) {
      mesh = shape.build();
    } else {
      Random random = Random(finish.seed).fork(kShapeStream);
      mesh = shape.build(random);
    }
    finish.apply(mesh);
    return mesh;
  }
};

class Shapes {
 public:
  template <class Shape>
  Shapes& add(const std::string& name, std::string help) {
    table_.add(name, std::move(help), Finished<Shape>(), [name](const Finished<Shape>& shape) {
      try {
        return shape.build();
      } catch (const ParameterError& error) {
        throw ParameterError(name + ": " + error.what());
      }
    });
    return *this;
  }
  const Factory<Mesh>& table() const { return table_; }

 private:
  Factory<Mesh> table_{"shape"};
};

}  // namespace

const Factory<Mesh>& shape_table() {
  using namespace shapes;
  static const Shapes all =
      Shapes()
          .add<Box>("box", "box about the origin, rectilinear")
          .add<LShape>("lshape", "L-shaped solid, rectilinear")
          .add<Stairs>("stairs", "solid flight of stairs, rectilinear")
          .add<SteppedPyramid>("stepped-pyramid", "square pyramid of steps, rectilinear (Fig. 15)")
          .add<Pyramid>("pyramid", "square pyramid")
          .add<Prism>("prism", "regular prism")
          .add<Cylinder>("cylinder", "circular cylinder: a regular prism of many sides")
          .add<CutCube>("cut-cube", "unit cube with a part cut off by a plane (Fig. 8)")
          .add<FilletedCube>("filleted-cube", "unit cube with rounded edges and corners (Fig. 9)")
          .add<Sphere>("sphere", "sphere")
          .add<Ellipsoid>("ellipsoid", "ellipsoid (Fig. 10)")
          .add<Torus>("torus", "torus about the z axis")
          .add<Blob>("blob", "random bumpy star-shaped surface with any number of faces")
          .add<Soup>("soup", "loose random triangles");
  return all.table();
}

Mesh make_shape(const Spec& spec) { return shape_table().find(spec.name).make(spec.settings); }

}  // namespace rectilin
