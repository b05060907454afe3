// Prints the results of `rectilin measure`: a table, or one line of JSON for each mesh.
#pragma once

#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/measure/measure.h"
#include "terminal.h"

namespace rectilin::app {

/// The result for a mesh, with what its reader had to say.
struct MeasuredMesh {
  Rectilinearity result;
  MeshReport report;
  std::string proof;  ///< the text of the proof, if one was asked for
};

/// Prints rows in the order of the sources.
class MeasurePrinter {
 public:
  MeasurePrinter(const std::vector<std::string>& sources, bool json);

  /// Prints a row; an error becomes one line on standard error. Throws std::runtime_error if standard output cannot be
  /// written, because later results would be lost as well.
  void print(const std::string& name, const Outcome<MeasuredMesh>& row);
  std::size_t failed() const { return failed_; }

 private:
  bool json_;
  Table table_;
  std::size_t failed_ = 0;
};

}  // namespace rectilin::app
