// Shapes with flat sides. What each struct binds documents its shape.
#pragma once

#include <array>

#include "rectilin/base/parameters.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::shapes {

struct Box {
  double x = 1, y = 1, z = 1;
  int faces = 12;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Pyramid {
  double base = 1, height = 1;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Prism {
  int sides = 6;
  double radius = 0.5, height = 1;
  bool caps = true;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Cylinder : Prism {
  Cylinder() { sides = 64; }
};

struct LShape {
  double x = 1, y = 1, z = 1, notch = 0.5;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct Stairs {
  double x = 1, y = 1, z = 1;
  int steps = 4;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct SteppedPyramid {
  double base = 1, height = 1;
  int steps = 4;
  void bind(Parameters& parameters);
  Mesh build() const;
};

struct CutCube {
  std::array<double, 3> direction{1, 1, 1};
  double depth = 0.25;
  void bind(Parameters& parameters);
  Mesh build() const;
};

}  // namespace rectilin::shapes
