// Meshes of an experiment and their certified R.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/rotation.h"
#include "rectilin/measure/measure.h"
#include "rectilin/paper/experiment.h"
#include "rectilin/render/thumbnail.h"
#include "rectilin/report/contact_sheet.h"

namespace rectilin::paper::figures {

using render::Up;
using report::ContactSheet;
using report::SheetCell;

/// A mesh that is made when it is needed: an experiment may have more of them than fit into memory.
struct Sample {
  std::string label;                ///< short, for people
  std::string origin;               ///< a source for load_mesh(), perhaps with what was done to it
  std::function<Mesh()> make;       ///< thread safe; the same mesh every time
  std::optional<Up> pictured = {};  ///< to be shown, this way up
};

/// The mesh of a source for load_mesh().
Sample sample(std::string label, const std::string& source);

/// The setting `up` of experiments that show meshes of others.
struct UpAxis {
  enum class Which { kAuto, kY, kZ };
  Which which = Which::kAuto;

  void bind(Parameters& parameters);
  /// Built-in shapes stand on the xy plane; most files have y up.
  Up of(const std::string& source) const;
};

/// A mesh in memory that others are made from.
struct Model {
  std::string title;   ///< short, unique
  std::string source;  ///< for load_mesh()
  std::shared_ptr<const Mesh> mesh;
};

/// Titles and sources of meshes.
using Defaults = std::vector<std::pair<std::string, std::string>>;

/// The context's meshes or, if it has none, the defaults. Meshes that cannot be read are left out,
/// with a line in `errors`; throws MeshError if there is none left.
std::vector<Model> load_models(const ExperimentContext& context, const Defaults& defaults,
                               std::vector<std::string>& errors);

/// What stands for a model made by hand and for a scan where no meshes are given; the scan has that
/// many faces.
Defaults made_and_scanned(int faces);

struct Measured {
  std::string error;      ///< if it could not be measured: then nothing else is set
  Rectilinearity result;  ///< with certified bounds
  std::string picture;    ///< a PNG file if it was to be shown

  double value() const { return result.value; }
  double lower() const { return result.bounds->lower; }
  double upper() const { return result.bounds->upper; }
};

/// R of each, certified, several at a time; the same for any number of threads. Throws Stopped.
std::vector<Measured> measure_all(const std::vector<Sample>& samples, const ExperimentContext& context);

/// One object for each sample, with the error instead of numbers where there is one.
Json to_json(const std::vector<Sample>& samples, const std::vector<Measured>& results);

/// The same as a table, and the pictures of those that are to be shown.
Sheet sheet(std::string name, std::string caption, const std::vector<Sample>& samples,
            const std::vector<Measured>& results, int columns = 4);

/// The errors among the results.
std::vector<std::string> errors(const std::vector<Measured>& results);

/// R as the paper prints it, with four digits.
std::string four_digits(double rectilinearity);
/// A number in six digits at most, as in the settings of a shape.
std::string number(double x);

}  // namespace rectilin::paper::figures
