// Python's exceptions of our own, and C++ text for those of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace rectilin::python {

namespace py = pybind11;

/// MeshError and ParameterError become rectilin.MeshError and rectilin.ParameterError, both kinds of ValueError.
void bind_errors(py::module_& m);

/// rectilin.Exhausted: raised to whoever asks for more when nothing is left. Like KeyboardInterrupt it is no Exception,
/// so that a search which survives everything ends all the same.
py::handle exhausted_type();

/// "ValueError: what it says (search.py, line 12)". Needs the GIL.
std::string one_line(py::error_already_set& error);

}  // namespace rectilin::python
