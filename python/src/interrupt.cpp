#include "interrupt.h"

#include <limits>

#include "rectilin/optim/evaluator.h"

namespace rectilin::python {

Interrupt::Interrupt(py::object progress) : progress_(std::move(progress)) {
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0) throw py::type_error("progress is not callable");
}

void Interrupt::attach(RunSettings& settings) {
  settings.stop = token();
  settings.on_progress = [this](const Evaluator& run) {
    const py::gil_scoped_acquire acquire;
    poll();
    if (progress_.is_none() || error_) return;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    try {
      progress_(run.costs().evaluations(), run.seconds(),
                run.has_incumbent() ? run.objective().merit(run.incumbent().value) : nan,
                run.lower_bound() ? run.objective().merit(*run.lower_bound()) : nan);
    } catch (py::error_already_set&) {
      raise_later(std::current_exception());
    }
  };
}

void Interrupt::poll() {
  if (PyErr_CheckSignals() == 0) return;
  try {
    throw py::error_already_set();
  } catch (py::error_already_set&) {
    raise_later(std::current_exception());
  }
}

void Interrupt::raise_later(std::exception_ptr error) {
  if (!error_) error_ = std::move(error);
  stop_.request_stop();
}

void Interrupt::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

}  // namespace rectilin::python
