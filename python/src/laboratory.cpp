#include "laboratory.h"

#include <pybind11/stl.h>

#include <map>
#include <mutex>
#include <set>

#include "beside.h"
#include "errors.h"
#include "measure.h"
#include "mesh.h"
#include "optim.h"
#include "rectilin/base/fnv1a.h"
#include "rectilin/laboratory/comparison.h"
#include "rectilin/laboratory/report.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "threads.h"

namespace rectilin::python {
namespace {

struct NoOptions {
  void bind(Parameters&) {}
};

/// The meshes of a comparison: sources by their names, and problems that are in memory.
struct Problems {
  std::vector<std::string> names;
  std::map<std::string, std::shared_ptr<Problem>> in_memory;

  void add(std::string name, std::shared_ptr<Problem> problem) {
    names.push_back(name);
    in_memory[std::move(name)] = std::move(problem);
  }
};

Problems problems_of(py::handle given) {
  Problems problems;
  if (py::isinstance<py::dict>(given)) {
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
      const std::string name = py::str(key);
      problems.add(name, problem_of(value, py::none(), name));
    }
    return problems;
  }
  const bool one = is_source(given) || py::isinstance<Problem>(given) || py::isinstance<OwnMesh>(given);
  const py::list list = one ? py::list(py::make_tuple(given)) : py::list(py::reinterpret_borrow<py::object>(given));
  for (const py::handle item : list) {
    if (is_source(item)) {
      for (std::string& name : expand_folders({source_of(item)})) problems.names.push_back(std::move(name));
    } else {
      std::shared_ptr<Problem> problem = problem_of(item, py::none(), std::nullopt);
      std::string name = problem->objective->name();
      problems.add(std::move(name), std::move(problem));
    }
  }
  return problems;
}

/// The competitors, with a registry that knows those written in Python.
class Competitors {
 public:
  Competitors(std::string domain, std::shared_ptr<AtWork> at_work, Interrupt& interrupt)
      : domain_(std::move(domain)), at_work_(std::move(at_work)), interrupt_(interrupt) {
    domain_by_name(domain_);
  }

  void add_all(py::handle given) {
    if (py::isinstance<py::dict>(given)) {
      for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
        if (py::isinstance<py::str>(value)) add_spec(std::string(py::str(key)), value.cast<std::string>());
        else add_callable(std::string(py::str(key)), value);
      }
    } else if (py::isinstance<py::str>(given)) {
      add_list(given.cast<std::string>());
    } else if (PyCallable_Check(given.ptr()) != 0) {
      add_callable(std::nullopt, given);
    } else {
      for (const py::handle item : py::list(py::reinterpret_borrow<py::object>(given))) {
        if (py::isinstance<py::str>(item)) add_list(item.cast<std::string>());
        else add_callable(std::nullopt, item);
      }
    }
  }

  const std::vector<laboratory::Entry>& entries() const { return entries_; }
  const Registry& registry() const { return registry_; }

 private:
  void add_list(const std::string& text) {
    for (laboratory::Entry& entry : laboratory::parse_entries({text}, {domain_}, registry_))
      entries_.push_back(std::move(entry));
  }

  void add_spec(std::string label, const std::string& spec) {
    std::vector<laboratory::Entry> entries = laboratory::parse_entries({spec}, {domain_}, registry_);
    if (entries.size() != 1) throw ParameterError("'" + label + "' is not one optimizer but '" + spec + "'");
    entries.front().label = std::move(label);
    entries_.push_back(std::move(entries.front()));
  }

  void add_callable(std::optional<std::string> label, py::handle search) {
    if (PyCallable_Check(search.ptr()) == 0)
      throw py::type_error("an optimizer is a text such as 'ga?population=100' or a callable, not " +
                           std::string(py::str(py::type::of(search))));
    std::string name = name_of_callable(search);
    const std::string own = name.substr(name.find(':') + 1);
    for (int i = 2; !names_.insert(name).second; ++i) name = "python:" + own + "_" + std::to_string(i);
    const auto function = py::reinterpret_borrow<py::function>(search);
    registry_.add(name, "written in Python", NoOptions(),
                  [this, function = share(function), name](NoOptions, const Registry&) {
                    const py::gil_scoped_acquire acquire;
                    return std::make_unique<CallableOptimizer>(*function, name, at_work_, interrupt_, false);
                  });
    entries_.push_back({label.value_or(own), name, domain_});
  }

  /// Copies of a registry copy its makers, on threads that may not have the GIL.
  static std::shared_ptr<const py::function> share(const py::function& function) {
    return {new py::function(function), [](const py::function* f) {
              const py::gil_scoped_acquire acquire;
              delete f;
            }};
  }

  std::string domain_;
  std::shared_ptr<AtWork> at_work_;
  Interrupt& interrupt_;
  Registry registry_ = all_optimizers();
  std::vector<laboratory::Entry> entries_;
  std::set<std::string> names_;
};

struct Comparison {
  std::string folder;
  laboratory::ComparisonOutcome outcome;
  std::vector<std::string> troubles;
};

Comparison compare(py::handle problems, py::handle optimizers, py::object runs, py::object budget, py::object seed,
                   const std::string& domain, const std::string& certificate, py::handle out, py::object threads,
                   double patience, py::object progress) {
  Interrupt interrupt{py::none()};
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0) throw py::type_error("progress is not callable");
  if (!(patience > 0)) throw ParameterError("patience is not a positive number of seconds");
  const auto at_work = std::make_shared<AtWork>();
  const Problems meshes = problems_of(problems);
  Competitors competitors(domain, at_work, interrupt);
  competitors.add_all(optimizers);

  laboratory::Plan plan;
  plan.meshes = meshes.names;
  plan.entries = competitors.entries();
  plan.runs = static_cast<int>(std::min<std::uint64_t>(whole_number(runs, "runs", 1).value_or(15), 1'000'000));
  plan.budget = whole_number(budget, "budget", 1).value_or(10000);
  plan.seed = whole_number(seed, "seed", 0).value_or(1);
  plan.certificate = certificate;

  std::mutex mutex;
  laboratory::ComparisonProgress now;
  laboratory::ComparisonSettings settings;
  settings.stop = interrupt.token();
  settings.command_line = "rectilin.compare() in Python";
  settings.report = true;
  settings.on_progress = [&](const laboratory::ComparisonProgress& state) {
    const std::lock_guard lock(mutex);
    now = state;
  };
  settings.load = [&](const std::string& name) {
    const auto problem = meshes.in_memory.find(name);
    return problem == meshes.in_memory.end() ? laboratory::load_compared_mesh(name) : compared(*problem->second);
  };

  Comparison result;
  result.folder = source_of(out);
  const auto limit = limit_threads(threads);
  try {
    std::size_t told = 0;
    beside(
        [&] {
          result.outcome = run_comparison(plan, result.folder, competitors.registry(), settings);
          result.troubles = result.outcome.pictures.lines;
        },
        [&] {
          interrupt.poll();
          at_work->end_silent(patience, interrupt.token().stop_requested());
          if (progress.is_none() || interrupt.token().stop_requested()) return;
          laboratory::ComparisonProgress state;
          {
            const std::lock_guard lock(mutex);
            state = now;
          }
          if (state.total == 0 || state.done == told) return;
          told = state.done;
          try {
            progress(state.done, state.total, state.text);
          } catch (py::error_already_set&) {
            interrupt.raise_later(std::current_exception());
          }
        });
  } catch (...) {
    interrupt.rethrow();
    throw;
  }
  interrupt.rethrow();
  return result;
}

py::object read_json(const std::string& folder, const char* file) {
  const py::object path = py::module_::import("pathlib").attr("Path")(folder) / py::str(file);
  return py::module_::import("json").attr("loads")(path.attr("read_text")(py::arg("encoding") = "utf-8"));
}

/// The lines of runs.jsonl, by problem, optimizer and run.
py::list runs_of(const Comparison& c) {
  const py::object path = py::module_::import("pathlib").attr("Path")(c.folder) / py::str("runs.jsonl");
  const py::object loads = py::module_::import("json").attr("loads");
  py::list runs;
  const py::list lines = path.attr("read_text")(py::arg("encoding") = "utf-8").attr("strip")().attr("split")("\n");
  for (const py::handle line : lines) runs.append(loads(line));
  const py::object key = py::module_::import("operator").attr("itemgetter")("mesh", "entry", "run");
  runs.attr("sort")(py::arg("key") = key);
  return runs;
}

}  // namespace

laboratory::ComparedMesh compared(const Problem& problem) {
  laboratory::ComparedMesh mesh{problem.objective->vectors(), problem.faces, ""};
  Fnv1a hash;
  for (const AlignedDoubles* component : {&mesh.vectors.x, &mesh.vectors.y, &mesh.vectors.z})
    for (const double x : *component) hash.add(x);
  mesh.digest = "vectors:" + std::to_string(hash.value());
  return mesh;
}

void bind_laboratory(py::module_& m) {
  py::class_<Comparison>(m, "Comparison",
                         "A finished comparison: what compare() gives. Its numbers are files in `folder`.")
      .def_readonly("folder", &Comparison::folder)
      .def_property_readonly(
          "page", [](const Comparison& c) { return c.folder + "/index.html"; }, "The page with the result.")
      .def_property_readonly(
          "failed_runs", [](const Comparison& c) { return c.outcome.failed_runs; },
          "The page lists them; so does runs.")
      .def_property_readonly(
          "mesh_errors", [](const Comparison& c) { return c.outcome.mesh_errors; },
          "One line for each mesh that could not be measured.")
      .def_property_readonly(
          "losses", [](const Comparison& c) { return c.outcome.losses; },
          "One line for each mesh that is not all that its file holds.")
      .def_readonly("troubles", &Comparison::troubles, "Why pictures are missing, if they are: they take gnuplot.")
      .def_property_readonly(
          "summary", [](const Comparison& c) { return read_json(c.folder, "summary.json"); },
          "summary.json: gaps, expected running times, ranks and tests.")
      .def_property_readonly("runs", &runs_of,
                             "A dict for each run: mesh, entry (the optimizer), run, outcome, error, merit (R), "
                             "evaluations, trace (lists evaluations, seconds, merit) and more.")
      .def("__repr__", [](const Comparison& c) { return "<rectilin.Comparison in '" + c.folder + "'>"; });

  m.def("compare", &compare, py::arg("problems"), py::arg("optimizers"), py::kw_only(), py::arg("runs") = 15,
        py::arg("budget") = 10000, py::arg("seed") = 1, py::arg("domain") = "covering",
        py::arg("certificate") = laboratory::Plan().certificate, py::arg("out") = "comparison",
        py::arg("threads") = py::none(), py::arg("patience") = 60.0, py::arg("progress") = py::none(),
        R"(Compares optimizers and writes a page with the result.

problems: sources (files, folders, shapes), Problems or meshes in a list, or a dict of them by name. optimizers: texts,
callables, or a dict of both by name: {'ga': 'ga', 'gray': 'ga?encoding=gray@zone', 'mine': my_search}. Each runs `runs`
times on each problem, every time on another random rotation of it, on `budget` evaluations; the optimum is bounded by a
proof first. out: the folder; interrupted comparisons go on where they were. domain: the box that optimizers search who
name none. progress: called now and then with (done, total, text).

A callable my_search(problem, budget, rng) asks through `problem`, an Evaluator, which counts, records and enforces the
budget, and returns nothing. What it raises is a failed run of one line on the page. One that asks for nothing in
`patience` seconds is ended and has failed; a call of C that never returns cannot be. Callables run one at a time, as
Python does; their objective does not.

Returns a Comparison. Raises ParameterError for a plan that cannot be, RuntimeError or OSError if the folder cannot be
written. Ctrl-C stops it and loses no finished run.

    >>> def dice(problem, budget, rng):
    ...     problem.values(rng.normal(size=(budget, 4)))
    >>> c = rectilin.compare(['shape:pyramid'], {'dice': dice, 'grid': 'grid'}, runs=2, budget=200, out=folder)
    >>> [r['evaluations'] for r in c.runs if r['entry'] == 'dice']
    [200, 200])");
}

}  // namespace rectilin::python
