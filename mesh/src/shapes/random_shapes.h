// Random shapes. What each struct binds documents its shape.
#pragma once

#include "rectilin/base/parameters.h"
#include "rectilin/base/random.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::shapes {

struct Blob {
  int faces = 10'000;
  int waves = 12;
  double amplitude = 0.2, frequency = 6;
  void bind(Parameters& parameters);
  Mesh build(Random& random) const;
};

struct Soup {
  int faces = 1000;
  double size = 0.2;
  void bind(Parameters& parameters);
  Mesh build(Random& random) const;
};

}  // namespace rectilin::shapes
