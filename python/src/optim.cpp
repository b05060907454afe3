#include "optim.h"

#include <pybind11/stl.h>

#include "evaluator.h"
#include "measure.h"
#include "mesh.h"
#include "objective.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/run_record.h"
#include "tables.h"
#include "threads.h"

namespace rectilin::python {
namespace {

using Form = std::optional<std::string>;

std::size_t directions_of(const Problem& problem) { return problem.objective->vectors().size(); }

std::shared_ptr<Problem> problem_of_normals(py::handle normals, py::handle weights, std::string name) {
  const py::array_t<double> rows = real_rows(normals, "N");
  const std::vector<double> weight_list = weights_of(weights, rows.shape(0));
  const py::gil_scoped_release release;
  AreaVectors vectors = area_vectors_of_normals(vectors_in(rows), weight_list);
  const std::size_t faces = vectors.faces;
  return std::make_shared<Problem>(
      Problem{std::make_shared<const ProjectedArea>(std::move(vectors), std::move(name)), faces});
}

/// Area vectors over the surface: their lengths add up to 1.
py::array_t<double> vectors_of(const Problem& problem) {
  const Generators generators = problem.objective->generators();
  py::array_t<double> array({static_cast<py::ssize_t>(generators.size()), py::ssize_t{3}});
  double* out = array.mutable_data();
  for (std::size_t i = 0; i < generators.size(); ++i)
    for (int k = 0; k < 3; ++k) *out++ = generators[i][k];
  return array;
}

std::shared_ptr<Measured> measure_problem(const Problem& problem, const MeasureArguments& arguments) {
  if (arguments.proof) throw ParameterError("a proof is about a mesh: ask measure() for it");
  MeasureOptions options = measure_options_of(arguments);
  Interrupt interrupt(arguments.progress);
  interrupt.attach(options.run);
  const auto limit = limit_threads(arguments.threads);
  return without_gil(interrupt, [&] {
    auto measured = std::make_shared<Measured>(Measured{measure(*problem.objective, options), ""});
    measured->result.faces = problem.faces;
    return measured;
  });
}

RunRecord optimize(const Problem& problem, py::object optimizer, py::object budget, py::object seconds, py::object seed,
                   const std::string& domain, py::object threads, py::object progress) {
  RunSettings settings;
  if (const auto count = whole_number(budget, "budget", 1)) settings.budget.evaluations = *count;
  if (const auto limit = positive_number(seconds, "seconds")) settings.budget.seconds = *limit;
  settings.seed = whole_number(seed, "seed", 0).value_or(1);
  settings.domain = &domain_by_name(domain);
  Interrupt interrupt(std::move(progress));
  interrupt.attach(settings);
  const auto limit = limit_threads(threads);

  std::unique_ptr<Optimizer> search;
  if (py::isinstance<py::str>(optimizer)) {
    search = all_optimizers().make(optimizer.cast<std::string>());
  } else if (PyCallable_Check(optimizer.ptr()) != 0) {
    search = std::make_unique<CallableOptimizer>(py::reinterpret_borrow<py::function>(optimizer),
                                                 name_of_callable(optimizer), std::make_shared<AtWork>(), interrupt,
                                                 /*raise_all=*/true);
  } else {
    throw py::type_error("an optimizer is a text such as 'ga?population=100' or a callable");
  }
  require_needs(*search, *problem.objective);
  RunRecord run = without_gil(interrupt, [&] { return run_optimizer(*search, *problem.objective, settings); });
  if (run.outcome == RunRecord::Outcome::kFailed) throw std::runtime_error(run.error);
  return run;
}

py::list list_optimizers() {
  py::list list;
  for (const Registry::Entry& entry : all_optimizers().entries()) {
    py::dict optimizer = entry_dict(entry);
    optimizer["capabilities"] = to_python(to_json(all_optimizers().make(entry.name)->capabilities()));
    list.append(optimizer);
  }
  return list;
}

void bind_domain(py::module_& m) {
  py::class_<Domain>(m, "Domain", R"(A box of three numbers that stand for rotations: what most optimizers search.

'covering': [0, pi] x [0, pi/2]^2 in the paper's angles, reaches all orientations; 'paper': [0, pi/2]^3, three quarters of
them; 'zone': a cube of Rodrigues vectors, all.

    >>> rectilin.domain('zone').upper.round(3)
    array([0.414, 0.414, 0.414]))")
      .def_property_readonly("name", [](const Domain& d) { return std::string(d.name()); })
      .def_property_readonly(
          "lower", [](const Domain& d) { return to_array(Vector3(d.lower())); }, "(3,): the box's corner.")
      .def_property_readonly(
          "upper", [](const Domain& d) { return to_array(Vector3(d.upper())); }, "(3,): the opposite corner.")
      .def_property_readonly("covers", &Domain::covers, "Does the box reach every frame?")
      .def(
          "rotation",
          [](const Domain& d, py::handle x) {
            const Rotations rotations = rotations_of(x, "domain", &d);
            return to_array(rotations.items.size(), rotations.one,
                            [&](std::size_t i) -> const Eigen::Matrix3d& { return rotations.items[i].matrix(); });
          },
          py::arg("x"), "Matrices, (3, 3) or (n, 3, 3), of points (3,) or (n, 3).")
      .def(
          "coordinates",
          [](const Domain& d, py::handle rotation, const Form& form) {
            return to_array(Vector3(d.coordinates(rotation_of(rotation, form, nullptr))));
          },
          py::arg("rotation"), py::arg("form") = py::none(), "(3,): the point nearest to a rotation's frame.");
  m.def(
      "domain", &domain_by_name, py::arg("name"), py::return_value_policy::reference,
      R"(The Domain 'covering', 'paper' or 'zone'.

    >>> rectilin.domain('paper').covers
    False)");
}

void bind_problem(py::module_& m) {
  py::class_<Problem, std::shared_ptr<Problem>>(m, "Problem", R"(The objective of a mesh: P/S as a function of rotations, to be minimised.

Problem(V, F, name=...) or Problem(mesh): V and F, an object that has both, or a source, as for measure(). P/S lies in
[1, sqrt(3)], and R = rectilinearity(P/S). Keeps what it needs: the arrays may change afterwards.

Rotations are given as matrices (3, 3), whose rows are the frame's axes in the mesh's coordinates, as quaternions (4,) in
the order x, y, z, w and of any length, as a Rotation of scipy, or with form= as 'rodrigues' vectors (tan(angle / 2) times
the axis), rotation 'vector's (radians) or the paper's 'angles' (radians); one, or an array of n.

    >>> import numpy as np
    >>> box = rectilin.Problem('shape:box')
    >>> box.values(np.eye(3))
    1.0
    >>> box.values([[0, 0, 0], [0.1, 0, 0]], form='rodrigues').shape
    (2,))")
      .def(py::init(&problem_of), py::arg("V"), py::arg("F") = py::none(), py::arg("name") = py::none())
      .def_static("from_normals", &problem_of_normals, py::arg("N"), py::arg("weights") = py::none(),
                  py::arg("name") = "normals", "The problem of directions with weights, see measure_normals().")
      .def_property_readonly("name", [](const Problem& p) { return p.objective->name(); })
      .def_property_readonly("faces", [](const Problem& p) { return p.faces; })
      .def_property_readonly("directions", &directions_of, "Distinct directions of faces.")
      .def_property_readonly(
          "area", [](const Problem& p) { return p.objective->vectors().area(); }, "In the square of the mesh's unit.")
      .def_property_readonly("vectors", &vectors_of,
                             "(directions, 3): the area vectors over the whole area; a row's length is its share of the "
                             "area, so P/S at R is abs(vectors @ R.T).sum(). A copy.")
      .def(
          "values",
          [](const Problem& p, py::handle rotations, const Form& form) {
            return values(*p.objective, directions_of(p), rotations_of(rotations, form, nullptr));
          },
          py::arg("rotations"), py::arg("form") = py::none(), "P/S: a float for one rotation, (n,) for n.")
      .def(
          "cuts",
          [](const Problem& p, py::handle rotations, const Form& form) {
            return cuts(*p.objective, directions_of(p), rotations_of(rotations, form, nullptr));
          },
          py::arg("rotations"), py::arg("form") = py::none(),
          "(values, gradients): linear minorants; (gradient * Q).sum() <= P/S at Q for every rotation Q, with equality "
          "where it was taken. Gradients are (3, 3) or (n, 3, 3).")
      .def(
          "smooth",
          [](const Problem& p, py::handle rotation, double width, const Form& form) {
            return smooth(*p.objective, directions_of(p), rotation_of(rotation, form, nullptr), width);
          },
          py::arg("rotation"), py::arg("width"), py::arg("form") = py::none(),
          "(value, gradient): a smooth upper bound that tends to P/S as width (radians) goes to 0. The gradient is with "
          "respect to the matrix's entries.")
      .def(
          "best_turn",
          [](const Problem& p, py::handle given, int axis, const Form& form) {
            require_axis(axis);
            const Rotation rotation = rotation_of(given, form, nullptr);
            BestTurn best;
            release_if_long(20 * directions_of(p), [&] { best = p.objective->best_turn(rotation, axis); });
            return py::make_tuple(to_array(best.rotation.matrix()), best.value);
          },
          py::arg("rotation"), py::arg("axis"), py::arg("form") = py::none(),
          "(rotation, value): the global minimum over all turns of the frame about its axis 0, 1 or 2.")
      .def(
          "measure",
          [](const Problem& p, double gap, std::string optimizer, bool optima, std::string domain, py::object seed,
             py::object budget, py::object seconds, py::object threads, py::object progress) {
            return measure_problem(p, {gap, std::move(optimizer), optima, false, std::move(domain), std::move(seed),
                                       std::move(budget), std::move(seconds), std::move(threads), std::move(progress)});
          },
          py::kw_only(), py::arg("gap") = CertifyOptions().gap, py::arg("optimizer") = "certify",
          py::arg("optima") = false, py::arg("domain") = "covering", py::arg("seed") = 1,
          py::arg("budget") = py::none(), py::arg("seconds") = py::none(), py::arg("threads") = py::none(),
          py::arg("progress") = py::none(),
          "The certified optimum, a Rectilinearity; the arguments are those of the function measure().")
      .def("__repr__", [](const Problem& p) {
        return "<rectilin.Problem '" + p.objective->name() + "': " + std::to_string(directions_of(p)) + " directions>";
      });
}

void bind_run(py::module_& m) {
  py::class_<RunRecord>(m, "Run", "One run of one optimizer: what optimize() gives.")
      .def_readonly("optimizer", &RunRecord::optimizer, "Its name.")
      .def_property_readonly("parameters", [](const RunRecord& r) { return to_python(r.parameters); })
      .def_readonly("domain", &RunRecord::domain)
      .def_readonly("seed", &RunRecord::seed)
      .def_property_readonly(
          "outcome", [](const RunRecord& r) { return to_string(r.outcome); },
          "'finished', 'budget' (spent) or 'stopped'.")
      .def_property_readonly(
          "value", [](const RunRecord& r) { return r.incumbent.value; }, "The least P/S found; inf if none was asked.")
      .def_readonly("rectilinearity", &RunRecord::merit, "R there; nan if there is none.")
      .def_property_readonly(
          "rotation", [](const RunRecord& r) { return to_array(r.incumbent.rotation.matrix()); },
          "(3, 3): where it was found, as its representative in the cubic fundamental zone.")
      .def_readonly("value_bound", &RunRecord::value_bound, "Proved: no rotation has less; None if nothing is proved.")
      .def_property_readonly(
          "evaluations", [](const RunRecord& r) { return r.costs.evaluations(); },
          "Spent: a value costs 1, a cut 2, a smooth value 5, a best turn 20.")
      .def_readonly("seconds", &RunRecord::seconds, "Wall clock.")
      .def_property_readonly("trace", &trace_of, R"(The run's history as a dict of arrays, one element a step:
evaluations, seconds, value (the best P/S so far), rectilinearity (the best R so far), lower (proved bound of P/S).

    >>> t = rectilin.optimize(rectilin.Problem('shape:pyramid'), 'random', budget=200).trace
    >>> bool((t['rectilinearity'][1:] > t['rectilinearity'][:-1]).all())
    True)")
      .def(
          "to_dict", [](const RunRecord& r) { return to_python(to_json(r)); }, "All but the trace, in plain types.")
      .def("__repr__", [](const RunRecord& r) {
        return "<rectilin.Run of " + r.optimizer + ": R " + std::to_string(r.merit) + " after " +
               std::to_string(r.costs.evaluations()) + " evaluations>";
      });
}

}  // namespace

std::shared_ptr<Problem> problem_of(py::handle given, py::handle faces, const std::optional<std::string>& name) {
  if (faces.is_none() && py::isinstance<Problem>(given)) {
    const auto problem = given.cast<std::shared_ptr<Problem>>();
    if (!name || *name == problem->objective->name()) return problem;
    return std::make_shared<Problem>(
        Problem{std::make_shared<const ProjectedArea>(AreaVectors(problem->objective->vectors()), *name), problem->faces});
  }
  const GivenMesh mesh(given, faces);
  const std::string own = mesh.name().empty() ? "mesh" : mesh.name();
  const py::gil_scoped_release release;
  return std::make_shared<Problem>(Problem{
      std::make_shared<const ProjectedArea>(area_vectors(mesh.view()), name.value_or(own)), mesh.view().triangles.size()});
}

void bind_optim(py::module_& m) {
  bind_domain(m);
  bind_problem(m);
  bind_evaluator(m);
  bind_run(m);
  m.def("optimizers", &list_optimizers,
        R"(The optimizers there are: a list of dicts with name, help, parameters and capabilities.

    >>> 'ga' in [o['name'] for o in rectilin.optimizers()]
    True)");
  m.def(
      "optimize",
      [](py::handle problem, py::object optimizer, py::object budget, py::object seconds, py::object seed,
         const std::string& domain, py::object threads, py::object progress) {
        return optimize(*problem_of(problem, py::none(), std::nullopt), std::move(optimizer), std::move(budget),
                        std::move(seconds), std::move(seed), domain, std::move(threads), std::move(progress));
      },
      py::arg("problem"), py::arg("optimizer"), py::kw_only(), py::arg("budget") = 10000,
      py::arg("seconds") = py::none(), py::arg("seed") = 1, py::arg("domain") = "covering",
      py::arg("threads") = py::none(), py::arg("progress") = py::none(),
      R"(Runs one optimizer on one problem.

problem: a Problem, or what makes one. optimizer: a text such as 'ga?population=100' or 'grid+nelder-mead', see
optimizers(); or a callable search(problem, budget, rng) of your own, which asks through `problem`, an Evaluator, and
returns nothing: the best rotation it asked for is the result. rng is numpy's default_rng of the seed. budget:
evaluations at most, None for no limit; seconds: at most. domain: the box for optimizers that search one. progress: see
measure().

Returns a Run. Raises ParameterError for what is not accepted, RuntimeError if an optimizer of the library fails, and
what your own raises.

    >>> run = rectilin.optimize('shape:pyramid', 'ga', budget=1000, seed=2)
    >>> run.evaluations
    1000)");
}

}  // namespace rectilin::python
