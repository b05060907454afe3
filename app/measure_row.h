// A mesh measured: a row of the table or a line of JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rectilin/mesh/mesh_io.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/run_record.h"
#include "terminal.h"

namespace rectilin::app {

/// A measured mesh, or why there is none.
struct Row {
  std::string name;
  std::string error;
  MeshReport report;
  std::size_t faces = 0, directions = 0;
  double area = 0;
  RunRecord run;
  double value_error = 0;  ///< rounding of the objective's values
  std::optional<CertifyResult> certified;
  Json parallel_faces;
  std::string proof;  ///< the text of one, if it was asked for
};

Row measure_mesh(const LoadedMesh& loaded, const Optimizer& optimizer, const RunSettings& settings, bool prove);
Json to_json(const Row& row);

/// Measures a source; with a proof if `prove` is set and the optimizer is Certify.
Row measure_source(const std::string& source, const Optimizer& optimizer, const RunSettings& settings, bool prove);

/// Prints rows in the order of the sources, as they come, with progress on a terminal.
class Printer {
 public:
  Printer(const std::vector<std::string>& sources, bool json);

  /// Throws std::runtime_error if standard output cannot be written: nobody would get what is still to be measured.
  void print(const Row& row);
  std::size_t failed() const { return failed_; }

 private:
  bool json_;
  Progress progress_;
  Table table_;
  std::size_t done_ = 0, failed_ = 0;
};

}  // namespace rectilin::app
