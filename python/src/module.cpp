// rectilin._rectilin: one bind function a house. To come beside them, as the houses do: pose, retrieval.
#include "errors.h"
#include "laboratory.h"
#include "measure.h"
#include "mesh.h"
#include "optim.h"
#include "rectilin/base/version.h"
#include "render.h"

PYBIND11_MODULE(_rectilin, m) {
  using namespace rectilin::python;
  m.doc() = "The compiled part of rectilin.";
  m.attr("__version__") = rectilin::version();
  bind_errors(m);
  bind_mesh(m);
  bind_measure(m);
  bind_render(m);
  bind_optim(m);
  bind_laboratory(m);
  bind_suite(m);
}
