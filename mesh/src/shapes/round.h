// Round shapes, of any fineness. What each struct binds documents its shape.
#pragma once

#include "rectilin/base/parameters.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::shapes {

/// Ways to divide the unit sphere into triangles. With all three the error falls with the square of the edge length.
struct Tessellation {
  enum class Kind {
    kOctahedral,  ///< an octahedron's faces divided into 4^subdivisions; has all its symmetries
    kLatLong,     ///< meridians and parallels, triangles crowded at the poles
    kEven         ///< rings about the axis of nearly equal triangles, any even number of them
  };
  Kind kind = Kind::kOctahedral;
  int subdivisions = 5;
  int slices = 64, stacks = 32;
  int faces = 10'000;

  void bind(Parameters& parameters);

  /// Throws ParameterError if a setting was changed that belongs to another kind of division.
  Mesh unit_sphere() const;
};

struct Sphere {
  double radius = 1;
  Tessellation tessellation;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Ellipsoid {
  double a = 1, b = 0.75, c = 0.5;
  Tessellation tessellation{Tessellation::Kind::kEven};
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Torus {
  double major = 1, minor = 0.4;
  int slices = 64, stacks = 32;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct FilletedCube {
  double radius = 0.2;
  int segments = 8;
  void bind(Parameters& parameters);
  Mesh build() const;
};

}  // namespace rectilin::shapes
