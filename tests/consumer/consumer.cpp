// What another project writes to use the installed libraries: a mesh in, R(M), its proof and its pose out.
#include <cstdio>

#include "rectilin/measure/measure.h"
#include "rectilin/mesh/shapes.h"

int main() {
  const rectilin::Mesh mesh = rectilin::make_shape(rectilin::Spec::parse("pyramid"));
  const rectilin::Rectilinearity r = rectilin::measure(mesh);
  std::printf("R = %.6f, between %.6f and %.6f\n", r.value, r.bounds->lower, r.bounds->upper);
  return r.bounds->lower <= 0.4270509832 && 0.4270509831 <= r.bounds->upper ? 0 : 1;
}
