// Meshes of an experiment and their certified R.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/experiments/experiment.h"
#include "rectilin/measure/mesh.h"
#include "rectilin/optim/rotation.h"
#include "thumbnail.h"

namespace rectilin::figures {

/// A mesh that is made when it is needed: an experiment may have more of them than fit into memory.
struct Specimen {
  std::string label;  ///< short, for people
  std::string
      origin;  ///< how to get it: a source for load_mesh(), perhaps with what was done to it
  std::function<Mesh()> make;       ///< thread safe; the same mesh every time
  std::optional<Up> pictured = {};  ///< to be shown, this way up
};

/// The mesh of a source for load_mesh().
Specimen specimen(std::string label, const std::string& source);

struct Measured {
  std::string error;  ///< if it could not be measured: then nothing else is set
  std::size_t faces = 0, directions = 0;
  double rectilinearity = 0;    ///< R at `rotation`
  double lower = 0, upper = 0;  ///< certified: lower <= R(M) <= upper
  Rotation rotation;
  std::string picture;  ///< a PNG file if it was to be shown
};

/// R of each, certified to 1e-6, several at a time; the same for any number of threads. Throws
/// Stopped.
std::vector<Measured> measure_all(const std::vector<Specimen>& specimens,
                                  const ExperimentContext& context);

/// One object for each specimen, with the error instead of numbers where there is one.
Json to_json(const std::vector<Specimen>& specimens, const std::vector<Measured>& results);

/// The same as a table, and the pictures with it. Only pictured specimens are shown.
Sheet sheet(std::string name, std::string caption, const std::vector<Specimen>& specimens,
            const std::vector<Measured>& results);

/// The errors among the results, each with its specimen's name.
std::vector<std::string> errors(const std::vector<Specimen>& specimens,
                                const std::vector<Measured>& results);

/// R as the paper prints it, with four digits.
std::string four_digits(double rectilinearity);
/// A number in six digits at most, as in the settings of a shape.
std::string number(double x);

}  // namespace rectilin::figures
