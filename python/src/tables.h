// Tables of things made from text, as lists of dicts.
#pragma once

#include "arrays.h"

namespace rectilin::python {

/// name, help, and parameters with name, default, accepts and help.
template <class Entry>
py::dict entry_dict(const Entry& entry) {
  py::list parameters;
  for (const auto& p : entry.parameters)
    parameters.append(py::dict(py::arg("name") = p.name, py::arg("default") = to_python(p.value),
                               py::arg("accepts") = p.accepts, py::arg("help") = p.help));
  return py::dict(py::arg("name") = entry.name, py::arg("help") = entry.help, py::arg("parameters") = parameters);
}

template <class Entries>
py::list list_entries(const Entries& entries) {
  py::list list;
  for (const auto& entry : entries) list.append(entry_dict(entry));
  return list;
}

}  // namespace rectilin::python
