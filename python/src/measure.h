// The house measure in Python: measure(), measure_normals(), verify() and what they give.
#pragma once

#include <string>

#include "arrays.h"
#include "interrupt.h"
#include "rectilin/measure/measure.h"

namespace rectilin::python {

/// rectilin.Rectilinearity.
struct Measured {
  Rectilinearity result;
  std::string proof;  ///< JSON; empty if none was asked for
};

/// The keyword arguments that measure(), measure_normals() and Problem.measure() share.
struct MeasureArguments {
  double gap;
  std::string optimizer;
  bool optima, proof;
  std::string domain;
  py::object seed, budget, seconds, threads, progress;
};

/// Throws ParameterError for what is not accepted.
MeasureOptions measure_options_of(const MeasureArguments& arguments);

/// Weights of so many normals; empty for None.
std::vector<double> weights_of(py::handle weights, py::ssize_t count);

/// A positive number, or none for None; throws ParameterError with the name.
std::optional<double> positive_number(py::handle number, const char* name);

/// The run's history as a dict of arrays.
py::dict trace_of(const RunRecord& run);

void bind_measure(py::module_& m);

}  // namespace rectilin::python
