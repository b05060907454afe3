#include "measure.h"

#include <pybind11/stl.h>

#include <cmath>

#include "mesh.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/normals.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "threads.h"

namespace rectilin::python {
namespace {

/// The proof is about a mesh of this digest.
std::string proof_text(const Rectilinearity& result, const std::string& digest) {
  return result.certificate ? to_text(to_json(*result.certificate, digest)) + '\n' : "";
}

std::shared_ptr<Measured> measure_mesh(py::handle vertices, py::handle faces, const MeasureArguments& arguments) {
  const GivenMesh given(vertices, faces);
  MeasureOptions options = measure_options_of(arguments);
  Interrupt interrupt(arguments.progress);
  interrupt.attach(options.run);
  const auto limit = limit_threads(arguments.threads);
  return without_gil(interrupt, [&] {
    auto measured = std::make_shared<Measured>();
    measured->result = measure(given.view(), options);
    if (options.certificate) measured->proof = proof_text(measured->result, mesh_digest(given.view()));
    return measured;
  });
}

std::shared_ptr<Measured> measure_normals(py::handle normals, py::handle weights, const MeasureArguments& arguments) {
  const py::array_t<double> rows = real_rows(normals, "N");
  const std::vector<double> weight_list = weights_of(weights, rows.shape(0));
  if (arguments.proof) throw ParameterError("a proof is about a mesh; normals have none");
  MeasureOptions options = measure_options_of(arguments);
  Interrupt interrupt(arguments.progress);
  interrupt.attach(options.run);
  const auto limit = limit_threads(arguments.threads);
  return without_gil(interrupt, [&] {
    const ProjectedArea objective(area_vectors_of_normals(vectors_in(rows), weight_list));
    return std::make_shared<Measured>(Measured{measure(objective, options), ""});
  });
}

Verdict verify(const std::string& proof, py::handle vertices, py::handle faces) {
  const GivenMesh given(vertices, faces);
  const py::gil_scoped_release release;
  return verify_certificate(proof, given.view());
}

py::object bound(const Measured& m, double Interval::*end) {
  return m.result.bounds ? py::object(py::float_((*m.result.bounds).*end)) : py::none();
}

const char* name_of(Optimum::Kind kind) {
  return kind == Optimum::Kind::kPoint ? "point" : kind == Optimum::Kind::kContinuum ? "continuum" : "possible";
}

py::list optima_of(const Measured& m) {
  py::list list;
  if (!m.result.proof) return list;
  for (const Optimum& optimum : m.result.proof->optima) {
    py::dict d;
    d["kind"] = name_of(optimum.kind);
    d["rectilinearity"] = rectilinearity(optimum.value);
    d["rotation"] = to_array(optimum.rotation.matrix());
    list.append(d);
  }
  return list;
}

py::list parallel_faces_of(const Measured& m) {
  py::list axes;
  for (const ParallelFaces& axis : m.result.parallel_faces)
    axes.append(py::dict(py::arg("count") = axis.count, py::arg("faces") = axis.first));
  return axes;
}

constexpr const char* kMeasureDoc = R"(R(M) of a mesh, its bounds, its proof and its pose.

V: (n, 3) coordinates. F: (m, 3) indices into V. Real numbers and integers of any type; float64 in C order is used where
   it lies, other arrays are converted. Or one argument: a Mesh, an object with .vertices and .faces (a mesh of trimesh,
   Open3D or meshio), or the name of a file or shape.
gap: width to which R is enclosed. optima: find every pose within the gap. proof: write the proof down, for verify().
optimizer: searches instead of proving, such as 'ga?population=100', with domain ('covering', 'paper', 'zone'), seed,
   budget (evaluations at most). seconds: at most. threads: at most; the answer is the same for any.
progress: called now and then with (evaluations, seconds, lower, upper).

Returns a Rectilinearity. Raises ValueError or TypeError for arrays that are no mesh, MeshError (a ValueError) for a mesh
without area, ParameterError (a ValueError) for settings. Ctrl-C ends it within about half a second. Do not change the
arrays meanwhile: the result would be of no mesh.

    >>> import numpy as np
    >>> V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    >>> F = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> r = rectilin.measure(V, F)
    >>> r.lower <= r.rectilinearity + 1e-9 and r.upper - r.lower < 2e-6
    True)";

constexpr const char* kNormalsDoc = R"(The same for directions with weights: a point cloud with normals, a Gauss map.

N: (n, 3) normals; only their directions count, not lengths nor sides. weights: (n,), not negative; all 1 for None.
The rotation found is the certified Manhattan frame in the L1 sense: its rows are the three orthogonal axes u that
minimise the weighted sum of |u . n|. The other arguments are measure()'s.

Raises MeshError, which names the place, for a normal that is zero or not finite and for a negative weight.

    >>> import numpy as np
    >>> rectilin.measure_normals(np.eye(3)).rectilinearity
    1.0)";

template <class Function, class... Extra>
void define_measure(py::module_& m, const char* name, Function function, const char* doc, const Extra&... extra) {
  m.def(
      name,
      [function](py::handle first, py::handle second, double gap, std::string optimizer, bool optima, bool proof,
                 std::string domain, py::object seed, py::object budget, py::object seconds, py::object threads,
                 py::object progress) {
        return function(first, second,
                        {gap, std::move(optimizer), optima, proof, std::move(domain), std::move(seed),
                         std::move(budget), std::move(seconds), std::move(threads), std::move(progress)});
      },
      extra..., py::kw_only(), py::arg("gap") = CertifyOptions().gap, py::arg("optimizer") = "certify",
      py::arg("optima") = false, py::arg("proof") = false, py::arg("domain") = "covering", py::arg("seed") = 1,
      py::arg("budget") = py::none(), py::arg("seconds") = py::none(), py::arg("threads") = py::none(),
      py::arg("progress") = py::none(), doc);
}

void bind_result(py::module_& m) {
  py::class_<Measured, std::shared_ptr<Measured>>(m, "Rectilinearity", R"(What there is to say of a mesh: see measure().

The names are those of the command's JSON (README), and to_dict() is that JSON.)")
      .def_property_readonly(
          "rectilinearity", [](const Measured& s) { return s.result.value; }, "R at `rotation`, the best found.")
      .def_property_readonly(
          "lower", [](const Measured& s) { return bound(s, &Interval::lower); },
          "Proved: R(M) is at least this; None if nothing is proved.")
      .def_property_readonly(
          "upper", [](const Measured& s) { return bound(s, &Interval::upper); },
          "Proved: R(M) is at most this; None if nothing is proved.")
      .def_property_readonly(
          "rotation", [](const Measured& s) { return to_array(s.result.rotation.matrix()); },
          "(3, 3): its rows are the pose's axes in the mesh's coordinates; V @ rotation.T is the mesh in that pose.")
      .def_property_readonly(
          "angles", [](const Measured& s) { return to_array(Vector3(euler_from_rotation(s.result.rotation))); },
          "(3,): the rotation as the paper's alpha, beta, gamma (eqs. 35-37), in radians.")
      .def_property_readonly(
          "faces", [](const Measured& s) { return s.result.faces; }, "Triangles.")
      .def_property_readonly(
          "directions", [](const Measured& s) { return s.result.directions; },
          "Distinct directions of their normals, up to sign.")
      .def_property_readonly(
          "area", [](const Measured& s) { return s.result.area; }, "Surface area, in the square of the mesh's unit.")
      .def_property_readonly("optima", &optima_of,
                             "With optima=True the distinct poses within the gap: dicts of kind ('point', 'continuum' "
                             "or 'possible'), rectilinearity and rotation.")
      .def_property_readonly("parallel_faces", &parallel_faces_of,
                             "For each axis the triangles parallel to it within 1e-9: count, and the first ten.")
      .def_property_readonly(
          "proof", [](const Measured& s) { return s.proof.empty() ? py::object(py::none()) : py::str(s.proof); },
          "With proof=True the proof, JSON text for verify(); else None.")
      .def_property_readonly(
          "outcome", [](const Measured& s) { return to_string(s.result.run.outcome); },
          "'finished', 'budget' (spent) or 'stopped'.")
      .def_property_readonly(
          "evaluations", [](const Measured& s) { return s.result.run.costs.evaluations(); },
          "What the search cost, in values of P at one rotation.")
      .def_property_readonly(
          "seconds", [](const Measured& s) { return s.result.run.seconds; }, "Wall clock of the search.")
      .def_property_readonly(
          "trace", [](const Measured& s) { return trace_of(s.result.run); },
          "The search's history: a dict of arrays, see Run.trace.")
      .def(
          "to_dict", [](const Measured& s) { return to_python(to_json(s.result)); },
          "All of it as a dict of plain numbers, lists and strings: the command's JSON line.")
      .def("__repr__", [](const Measured& s) {
        char text[160];
        const int size = std::snprintf(text, sizeof text, "<rectilin.Rectilinearity %.9f", s.result.value);
        std::string repr(text, static_cast<std::size_t>(size));
        if (s.result.bounds) {
          std::snprintf(text, sizeof text, ", in [%.9f, %.9f]", s.result.bounds->lower, s.result.bounds->upper);
          repr += text;
        }
        return repr + ">";
      });

  py::class_<Verdict>(m, "Verdict", "What verify() says. True if the proof was accepted.")
      .def_readonly("accepted", &Verdict::accepted)
      .def_readonly("reason", &Verdict::reason, "One line, if refused.")
      .def_readonly("lower", &Verdict::lower, "Proved: R(M) is at least this.")
      .def_readonly("upper", &Verdict::upper, "Proved: R(M) is at most this.")
      .def_readonly("leaves", &Verdict::leaves, "Parts of the zone that were checked.")
      .def_readonly("cuts", &Verdict::cuts, "Sums over all faces that were computed again.")
      .def("__bool__", [](const Verdict& v) { return v.accepted; })
      .def("__repr__", [](const Verdict& v) {
        return "<rectilin.Verdict: " + (v.accepted ? std::string("accepted") : "refused: " + v.reason) + ">";
      });
}

}  // namespace

std::vector<double> weights_of(py::handle weights, py::ssize_t count) {
  if (weights.is_none()) return {};
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(weights);
  if (!array || array.ndim() != 1 || array.shape(0) != count)
    throw py::value_error("weights are not " + std::to_string(count) + " numbers, one for each normal");
  return {array.data(), array.data() + array.shape(0)};
}

MeasureOptions measure_options_of(const MeasureArguments& arguments) {
  const bool proves =
      arguments.optimizer.starts_with("certify") && (arguments.optimizer.size() == 7 || arguments.optimizer[7] == '?');
  MeasureOptions options;
  if (arguments.optimizer != "certify") options = measure_options(arguments.optimizer, all_optimizers());
  const CertifyOptions defaults;
  const bool other_gap = arguments.gap != defaults.gap;
  if (!proves && (other_gap || arguments.optima || arguments.proof))
    throw ParameterError("gap, optima and proof need the optimizer certify");
  if (other_gap) {
    if (!(arguments.gap >= 0 && arguments.gap <= 10))
      throw ParameterError("gap is " + std::string(py::repr(py::float_(arguments.gap))) + ", not a width from 0 to 10");
    options.certify.gap = arguments.gap;
  }
  if (arguments.optima) options.certify.optima = true;
  options.certificate = arguments.proof;
  options.run.domain = &domain_by_name(arguments.domain);
  options.run.seed = whole_number(arguments.seed, "seed", 0).value_or(1);
  if (const auto budget = whole_number(arguments.budget, "budget", 1)) options.run.budget.evaluations = *budget;
  if (const auto seconds = positive_number(arguments.seconds, "seconds")) options.run.budget.seconds = *seconds;
  return options;
}

std::optional<double> positive_number(py::handle number, const char* name) {
  if (number.is_none()) return std::nullopt;
  const double value = PyFloat_AsDouble(number.ptr());
  if (PyErr_Occurred() != nullptr) PyErr_Clear();
  else if (std::isfinite(value) && value > 0) return value;
  throw ParameterError(std::string(name) + " is " + said(number) + ", not a positive number");
}

py::dict trace_of(const RunRecord& run) {
  const auto n = static_cast<py::ssize_t>(run.trace.size());
  py::array_t<std::int64_t> evaluations(n);
  py::array_t<double> seconds(n), value(n), lower(n), merit(n);
  for (py::ssize_t i = 0; i < n; ++i) {
    const TracePoint& point = run.trace[static_cast<std::size_t>(i)];
    evaluations.mutable_at(i) = static_cast<std::int64_t>(point.evaluations);
    seconds.mutable_at(i) = point.seconds;
    value.mutable_at(i) = point.value;
    lower.mutable_at(i) = point.lower;
    merit.mutable_at(i) = rectilinearity(point.value);
  }
  py::dict trace;
  trace["evaluations"] = evaluations;
  trace["seconds"] = seconds;
  trace["value"] = value;
  trace["lower"] = lower;
  trace["rectilinearity"] = merit;
  return trace;
}

void bind_measure(py::module_& m) {
  bind_result(m);
  define_measure(m, "measure", &measure_mesh, kMeasureDoc, py::arg("V"), py::arg("F") = py::none());
  define_measure(m, "measure_normals", &measure_normals, kNormalsDoc, py::arg("N"), py::arg("weights") = py::none());
  m.def("verify", &verify, py::arg("proof"), py::arg("V"), py::arg("F") = py::none(),
        R"(Checks a proof from scratch, by code that shares nothing with the search.

proof: the text of Rectilinearity.proof or of the command's --proof. V, F: see measure(). Returns a Verdict, also for
text that is no proof.

    >>> mesh = rectilin.shape('pyramid')
    >>> rectilin.verify(rectilin.measure(mesh, proof=True).proof, mesh)
    <rectilin.Verdict: accepted>)");
  m.def(
      "read_normals",
      [](py::handle file) {
        const std::string path = source_of(file);
        WeightedNormals cloud = [&] {
          const py::gil_scoped_release release;
          return read_normals(path);
        }();
        const auto n = static_cast<py::ssize_t>(cloud.normals.size());
        py::array_t<double> normals({n, py::ssize_t{3}}, reinterpret_cast<const double*>(cloud.normals.data()));
        return py::make_tuple(normals, py::array_t<double>(n, cloud.weights.data()));
      },
      py::arg("file"), R"(Normals and weights of the points of a PLY file, for measure_normals().

Returns N, (n, 3), and weights, (n,): the file's `weight` or `area`, else 1. Points without a normal are left out.
Raises MeshError for a file without normals.

    >>> N, weights = rectilin.read_normals('cloud.ply')  # doctest: +SKIP)");
  m.def("rectilinearity", py::vectorize([](double value) { return rectilinearity(value); }), py::arg("value"),
        R"(R = 3 (S/P - 2/3) for values P/S of the objective: a float, or an array for an array.

    >>> rectilin.rectilinearity(1.0)
    1.0)");
}

}  // namespace rectilin::python
