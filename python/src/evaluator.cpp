#include "evaluator.h"

#include <pybind11/stl.h>

#include "errors.h"
#include "objective.h"

namespace rectilin::python {
namespace {

std::size_t size_of(const Evaluator& evaluator) { return evaluator.objective().generators().size(); }

using Form = std::optional<std::string>;

Rotations given_to(const LentEvaluator& self, py::handle rotations, const Form& form) {
  return rotations_of(rotations, form, &self.domain());
}

}  // namespace

Evaluator& LentEvaluator::get() const {
  if (evaluator_ == nullptr) throw std::runtime_error("the run is over: its problem can no longer be asked");
  if (PyThread_get_thread_ident() != thread_)
    throw std::runtime_error("asked from another thread than the one that the optimizer was called on");
  return *evaluator_;
}

Evaluator& LentEvaluator::ask() const {
  Evaluator& evaluator = get();
  if (!evaluator.exhausted()) {
    at_work_->asked(thread_);
    return evaluator;
  }
  // A search that catches everything and asks again is raised it once more when its next loop begins, where nothing
  // catches it.
  constexpr int kPatience = 100;  // refusals
  if (++refused_ > kPatience) PyThreadState_SetAsyncExc(thread_, exhausted_type().ptr());
  PyErr_SetString(exhausted_type().ptr(), "nothing is left of the budget, or the run was stopped");
  throw py::error_already_set();
}

void bind_evaluator(py::module_& m) {
  py::class_<LentEvaluator, std::shared_ptr<LentEvaluator>>(m, "Evaluator", R"(The problem as an optimizer sees it.

Asks like a Problem, on a budget: whatever is asked counts, the best rotation asked for is the run's result, and its
history is recorded. What a batch asks beyond the budget is infinite and not evaluated; who asks when nothing is left
gets Exhausted, which ends the run as planned. Asking in batches is much cheaper than one by one. Belongs to the thread
that the optimizer was called on, until the optimizer returns.

    >>> def dice(problem, budget, rng):
    ...     while True:
    ...         problem.values(rng.normal(size=(50, 4)))    # quaternions of any length
    >>> rectilin.optimize(rectilin.Problem('shape:box'), dice, budget=500).evaluations
    500)")
      .def(
          "values",
          [](const LentEvaluator& self, py::handle rotations, const Form& form) {
            Evaluator& evaluator = self.ask();
            return values(evaluator, size_of(evaluator), given_to(self, rotations, form));
          },
          py::arg("rotations"), py::arg("form") = py::none(),
          "P/S at one rotation (a float) or many (an array), as Problem.values(); form='domain' are points of the box.")
      .def(
          "cuts",
          [](const LentEvaluator& self, py::handle rotations, const Form& form) {
            Evaluator& evaluator = self.ask();
            return cuts(evaluator, size_of(evaluator), given_to(self, rotations, form));
          },
          py::arg("rotations"), py::arg("form") = py::none(), "As Problem.cuts(); counts as 2 evaluations each.")
      .def(
          "smooth",
          [](const LentEvaluator& self, py::handle rotation, double width, const Form& form) {
            Evaluator& evaluator = self.ask();
            return smooth(evaluator, size_of(evaluator), rotation_of(rotation, form, &self.domain()), width);
          },
          py::arg("rotation"), py::arg("width"), py::arg("form") = py::none(),
          "As Problem.smooth(); counts as 5 evaluations. The value counts for the result only once values() is asked.")
      .def(
          "best_turn",
          [](const LentEvaluator& self, py::handle given, int axis, const Form& form) {
            Evaluator& evaluator = self.ask();
            require_axis(axis);
            Rotation rotation = rotation_of(given, form, &self.domain());
            double value = 0;
            release_if_long(20 * size_of(evaluator), [&] { value = evaluator.turn(rotation, axis); });
            return py::make_tuple(to_array(rotation.matrix()), value);
          },
          py::arg("rotation"), py::arg("axis"), py::arg("form") = py::none(),
          "As Problem.best_turn(); counts as 20 evaluations.")
      .def_property_readonly(
          "domain", [](const LentEvaluator& self) { return &self.domain(); }, py::return_value_policy::reference,
          "The box that the run is to search, a Domain.")
      .def_property_readonly(
          "name", [](const LentEvaluator& self) { return self.get().objective().name(); }, "Of the mesh.")
      .def_property_readonly(
          "directions", [](const LentEvaluator& self) { return size_of(self.get()); },
          "Distinct directions of faces: what a value costs grows with them.")
      .def_property_readonly(
          "remaining", [](const LentEvaluator& self) { return self.get().remaining(); }, "Evaluations left.")
      .def_property_readonly(
          "evaluations", [](const LentEvaluator& self) { return self.get().costs().evaluations(); },
          "Evaluations spent.")
      .def_property_readonly(
          "exhausted", [](const LentEvaluator& self) { return self.get().exhausted(); },
          "Is the budget spent, the time over, or the run stopped? Then return.")
      .def_property_readonly(
          "best",
          [](const LentEvaluator& self) {
            const Incumbent& best = self.get().incumbent();
            return py::make_tuple(to_array(best.rotation.matrix()), best.value);
          },
          "The best rotation asked for so far, (3, 3), and its value: inf before the first.");
}

}  // namespace rectilin::python
