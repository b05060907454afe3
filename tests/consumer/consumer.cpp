// What another project writes to use the installed libraries: a mesh in, R(M) and the pose out.
#include <cmath>
#include <cstdio>

#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"

int main() {
  const rectilin::Mesh mesh = rectilin::make_shape(rectilin::Spec::parse("box"));
  const rectilin::ProjectedArea objective(rectilin::area_vectors(mesh));
  const auto optimizer = rectilin::builtin_optimizers().make("grid");
  const rectilin::RunRecord record = rectilin::run_optimizer(*optimizer, objective, {});
  std::printf("R = %.6f\n", record.merit);
  return std::abs(record.merit - 1) < 1e-9 ? 0 : 1;
}
