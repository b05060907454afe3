// Ctrl-C and progress while C++ works without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <functional>
#include <stop_token>

#include "rectilin/optim/run_record.h"

namespace rectilin::python {

namespace py = pybind11;

/// Python's handler of Ctrl-C only leaves a note; somebody must look. A run does so ten times a second, first after
/// half a second: that is as long as Ctrl-C takes. What the handler raises, or a progress function, stops the run and
/// is raised when it has ended.
class Interrupt {
 public:
  /// `progress(evaluations, seconds, lower, upper)`, or None.
  explicit Interrupt(py::object progress);

  /// Has the run look and stop.
  void attach(RunSettings& settings);

  /// Looks; needs the GIL.
  void poll();

  /// Keeps what was raised, as poll() does, and stops the run. Needs the GIL.
  void raise_later(std::exception_ptr error);

  /// Raises what was kept; needs the GIL.
  void rethrow() const;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  py::object progress_;
  std::stop_source stop_;
  std::exception_ptr error_;
};

/// Runs `work` without the GIL, then raises what came up in between.
template <class Work>
auto without_gil(const Interrupt& interrupt, const Work& work) {
  try {
    auto result = [&] {
      const py::gil_scoped_release release;
      return work();
    }();
    interrupt.rethrow();
    return result;
  } catch (...) {  // what was raised is the reason of whatever failed after it
    interrupt.rethrow();
    throw;
  }
}

}  // namespace rectilin::python
