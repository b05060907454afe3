// rectilin._rectilin: one bind function a house.
#include "errors.h"
#include "laboratory.h"
#include "measure.h"
#include "mesh.h"
#include "optim.h"
#include "pose.h"
#include "rectilin/base/version.h"
#include "render.h"
#include "retrieval.h"
#include "search.h"

PYBIND11_MODULE(_rectilin, m) {
  using namespace rectilin::python;
  m.doc() = "The compiled part of rectilin.";
  m.attr("__version__") = rectilin::version();
  bind_errors(m);
  bind_mesh(m);
  bind_measure(m);
  bind_render(m);
  bind_pose(m);
  bind_retrieval(m);
  bind_search(m);
  bind_optim(m);
  bind_laboratory(m);
  bind_suite(m);
}
