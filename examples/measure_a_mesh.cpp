// Measures a mesh: R with its proof, and the pose. Usage: example_measure_a_mesh [FILE or shape:NAME?key=value]
#include <cstdio>
#include <exception>

#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"

int main(int argc, char** argv) try {
  const rectilin::LoadedMesh loaded = rectilin::load_mesh(argc > 1 ? argv[1] : "shape:pyramid?rotate=random");
  const rectilin::Rectilinearity r = rectilin::measure(loaded.mesh);

  std::printf("R is between %.9f and %.9f\n", r.bounds->lower, r.bounds->upper);
  for (int k = 0; k < 3; ++k) {
    const rectilin::Vector3 axis = r.rotation.axis(k);
    std::printf("axis %d: %9.6f %9.6f %9.6f, parallel to %zu of %zu faces\n", k + 1, axis.x(), axis.y(), axis.z(),
                r.parallel_faces[k].count, r.faces);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
