#include "rectilin/laboratory/suite.h"

#include <pybind11/stl.h>

#include "interrupt.h"
#include "laboratory.h"
#include "mesh.h"
#include "optim.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/report.h"

namespace rectilin::python {
namespace {

py::list list_suites() {
  py::list list;
  for (const laboratory::Suite& suite : laboratory::suites()) {
    py::list problems;
    for (const laboratory::SuiteProblem& p : suite.problems)
      problems.append(
          py::dict(py::arg("name") = p.name, py::arg("source") = p.source, py::arg("landscape") = p.landscape));
    list.append(py::dict(py::arg("name") = suite.name, py::arg("help") = suite.help, py::arg("problems") = problems));
  }
  return list;
}

py::dict problems_of_suite(const std::string& name) {
  py::dict problems;
  for (const laboratory::SuiteProblem& p : laboratory::suite_by_name(name).problems)
    problems[py::str(p.name)] = problem_of(py::str(p.source), py::none(), p.name);
  return problems;
}

/// The problem with its certified optimum, as plain types and arrays.
py::dict exported(const Problem& problem, double gap) {
  MeasureOptions options;
  options.certify.gap = gap;
  Interrupt interrupt{py::none()};
  interrupt.attach(options.run);
  const Json json = without_gil(interrupt, [&] {
    const Rectilinearity optimum = measure(*problem.objective, options);
    return laboratory::problem_json(problem.objective->name(), "", compared(problem), optimum);
  });
  py::dict result = to_python(json);
  const auto array = py::module_::import("numpy").attr("array");
  for (const char* name : {"vectors", "rotation"}) result[name] = array(result[name]);
  return result;
}

void export_problem(const Problem& problem, py::handle file, double gap) {
  const std::string path = source_of(file);
  if (!(gap >= 0 && gap <= 10)) throw ParameterError("gap is not a width from 0 to 10");
  py::dict fields = exported(problem, gap);
  if (path.ends_with(".npz")) {
    for (const char* name : {"value_lower", "lower", "upper"})  // numpy's files hold no None
      if (fields[name].is_none()) fields.attr("pop")(name);
    py::module_::import("numpy").attr("savez")(path, **fields);
    return;
  }
  if (!path.ends_with(".json")) throw ParameterError(path + ": a problem is written to .json or .npz");
  for (const char* name : {"vectors", "rotation"}) fields[name] = fields[name].attr("tolist")();
  write_whole_file(path, py::module_::import("json").attr("dumps")(fields).cast<std::string>() + '\n');
}

std::size_t read_traces(py::handle folder, py::handle file, const std::optional<py::dict>& problems) {
  std::map<std::string, std::shared_ptr<Problem>> in_memory;
  if (problems)
    for (const auto& [key, value] : *problems) {
      const std::string name = py::str(key);
      in_memory[name] = problem_of(value, py::none(), name);
    }
  const auto load = [&](const std::string& name) {
    const auto problem = in_memory.find(name);
    return problem == in_memory.end() ? laboratory::load_compared_mesh(name) : compared(*problem->second);
  };
  const std::string into = source_of(folder), from = source_of(file);
  const py::gil_scoped_release release;
  const std::size_t runs = laboratory::add_foreign_runs(into, read_whole_file(from), from, load);
  laboratory::write_report(into);
  return runs;
}

}  // namespace

void bind_suite(py::module_& m) {
  m.def("suites", &list_suites, R"(The benchmark suites: a list of dicts with name, help and problems.

    >>> rectilin.suites()[0]['name']
    'landscapes-1')");
  m.def("suite", &problems_of_suite, py::arg("name"), R"(The problems of a suite, a dict of Problems by name.

Suites never change: what would change one gets another version in its name. So results can be compared with those of
others. Raises ParameterError for an unknown name.

    >>> problems = rectilin.suite('landscapes-1')
    >>> problems['box'].directions
    3)");
  m.def(
      "export",
      [](py::handle problem, py::handle file, double gap) {
        export_problem(*problem_of(problem, py::none(), std::nullopt), file, gap);
      },
      py::arg("problem"), py::arg("file"), py::kw_only(), py::arg("gap") = 1e-9,
      R"(Writes a problem with its certified optimum for programs in any language.

file: .json or .npz. It holds vectors, (n, 3): value(R) = np.abs(vectors @ R.T).sum() is to be minimised; rotation and
value, the best known; value_lower, which no rotation is below; and rectilinearity, lower, upper, the same as R(M).

    >>> rectilin.export('shape:pyramid', 'pyramid.npz')
    >>> problem = np.load('pyramid.npz')
    >>> bool(np.isclose(np.abs(problem['vectors'] @ problem['rotation'].T).sum(), problem['value']))
    True)");
  m.def("read_traces", &read_traces, py::arg("folder"), py::arg("file"), py::arg("problems") = py::none(),
        R"(Adds runs of other programs to the page of a comparison; returns how many.

folder: the comparison's. file: JSON lines, an object a run: problem, optimizer, run, evaluations and value (lists: the
best value so far, wherever it fell), rotation (three rows). problems: a dict by name of those problems of the comparison
that were made in memory. What can be checked is: raises ParameterError with the line's number for runs that cannot be.

    >>> c = rectilin.compare('shape:box', 'grid', runs=1, budget=50, out=folder)
    >>> line = '{"problem": "shape:box", "optimizer": "mine", "run": 0, "evaluations": [1], "value": [1.0], '
    >>> line += '"rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}'
    >>> _ = open('mine.jsonl', 'w').write(line)
    >>> rectilin.read_traces(folder, 'mine.jsonl')
    1)");
}

}  // namespace rectilin::python
