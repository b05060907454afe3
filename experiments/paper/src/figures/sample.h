// The meshes of an experiment, and their certified R.
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

/// A mesh that is made only when it is needed: an experiment may have more of them than fit into memory.
struct Sample {
  std::string label;                ///< short, for people
  std::string origin;               ///< a source for load_mesh(), or one and what was done to it
  std::function<Mesh()> make;       ///< thread safe; the same mesh every time; if empty, the mesh of `origin`
  std::optional<Up> pictured = {};  ///< set if it is to be shown: which way is up

  Mesh mesh(const ExperimentContext& context) const { return make ? make() : context.load(origin); }
};

/// A sample that loads a source with load_mesh().
Sample sample(std::string label, const std::string& source);

/// The setting `up` of experiments that show meshes from files.
struct UpAxis {
  enum class Which { kAuto, kY, kZ };
  Which which = Which::kAuto;

  void bind(Parameters& parameters);
  /// Built-in shapes stand on the xy plane; most files have y up.
  Up of(const std::string& source) const;
};

/// A mesh in memory from which others are made.
struct Model {
  std::string title;   ///< short, unique
  std::string source;  ///< for load_mesh()
  std::shared_ptr<const Mesh> mesh;
};

/// Titles and sources of meshes.
using Defaults = std::vector<std::pair<std::string, std::string>>;

/// The context's meshes or, if there are none, the defaults. Meshes that cannot be read are left out, with a line in
/// `errors`; throws MeshError if none is left.
std::vector<Model> load_models(const ExperimentContext& context, const Defaults& defaults,
                               std::vector<std::string>& errors);

/// Built-in shapes that replace a hand-made model and a scan if no meshes are given; the scan has that many faces.
Defaults made_and_scanned(int faces);

struct Measured {
  std::string error;      ///< why it could not be measured; then nothing else is set
  Rectilinearity result;  ///< with certified bounds
  std::string picture;    ///< the content of a PNG file, if it is to be shown

  double value() const { return result.value; }
  double lower() const { return result.bounds->lower; }
  double upper() const { return result.bounds->upper; }
};

/// Certifies R of all samples, several at a time; the results are the same for any number of threads. Throws Stopped.
std::vector<Measured> measure_all(const std::vector<Sample>& samples, const ExperimentContext& context);

/// One JSON object for each sample; if it failed, with the error instead of numbers.
Json to_json(const std::vector<Sample>& samples, const std::vector<Measured>& results);

/// The same as a table, and a sheet with the pictures of those that are to be shown.
Sheet sheet(std::string name, std::string caption, const std::vector<Sample>& samples,
            const std::vector<Measured>& results, int columns = 4);

/// The errors among the results.
std::vector<std::string> errors(const std::vector<Measured>& results);

/// R as the paper prints it, with four digits.
std::string four_digits(double rectilinearity);
/// A number in six digits at most, as in the settings of a shape.
std::string number(double x);

}  // namespace rectilin::paper::figures
