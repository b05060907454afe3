#include "errors.h"

#include <algorithm>
#include <filesystem>

#include "rectilin/base/parameters.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::python {
namespace {

PyObject* exhausted = nullptr;

/// The innermost frame: "search.py, line 12".
std::string place_of(py::handle trace) {
  if (!trace || trace.is_none()) return "";
  py::object frame = py::reinterpret_borrow<py::object>(trace);
  while (!frame.attr("tb_next").is_none()) frame = frame.attr("tb_next");
  std::string file = py::str(frame.attr("tb_frame").attr("f_code").attr("co_filename"));
  file = file.substr(file.rfind('/') + 1);
  return " (" + file + ", line " + std::string(py::str(frame.attr("tb_lineno"))) + ")";
}

/// A kind of ValueError that says in one line what `Error` says.
template <class Error>
void bind_line(py::module_& m, const char* name, const char* doc) {
  static PyObject* type = nullptr;  // kept for good: the translator has no other place for it
  type = PyErr_NewExceptionWithDoc(("rectilin." + std::string(name)).c_str(), doc, PyExc_ValueError, nullptr);
  if (type == nullptr) throw py::error_already_set();
  m.add_object(name, type);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const Error& e) {
      PyErr_SetString(type, printable(e.what()).c_str());
    }
  });
}

}  // namespace

void bind_errors(py::module_& m) {
  // The command's words: one line, whatever the names of files hold. What is registered last is tried first.
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const py::error_already_set&) {
      throw;
    } catch (const py::builtin_exception&) {
      throw;
    } catch (const std::filesystem::filesystem_error& e) {
      PyErr_SetString(PyExc_OSError, printable(e.path1().string() + ": " + system_reason(e.code())).c_str());
    } catch (const std::runtime_error& e) {
      PyErr_SetString(PyExc_RuntimeError, printable(e.what()).c_str());
    }
  });
  bind_line<MeshError>(m, "MeshError", "A mesh that cannot be read, made or measured. One line: file, place, reason.");
  bind_line<ParameterError>(m, "ParameterError",
                            "A wrong name, setting or value. One line: which, and what would be accepted.");
  exhausted = PyErr_NewExceptionWithDoc(
      "rectilin.Exhausted",
      "Nothing is left of a run's budget, or it was stopped. Raised when an optimizer asks on all the same. It ends "
      "the\n"
      "run as planned, so there is no need to catch it. Not an Exception, as KeyboardInterrupt is none.",
      PyExc_BaseException, nullptr);
  if (exhausted == nullptr) throw py::error_already_set();
  m.add_object("Exhausted", exhausted);
}

py::handle exhausted_type() { return exhausted; }

std::string one_line(py::error_already_set& error) {
  std::string text = py::str(error.type().attr("__name__"));
  try {
    const std::string what = py::str(error.value());
    if (!what.empty()) text += ": " + what.substr(0, what.find('\n'));
    text += place_of(error.trace());
  } catch (py::error_already_set&) {  // an exception that cannot even say what it is
  }
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

}  // namespace rectilin::python
