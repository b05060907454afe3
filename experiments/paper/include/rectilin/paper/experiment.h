// The experiments: the paper's figures and tables, and more. Each is a small program with a name that goes from meshes
// to plots, their data, and one line that compares the outcome with what the paper reports.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/base/factory.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/report/plot.h"

namespace rectilin::paper {

/// What an experiment gets besides its own settings.
struct ExperimentContext {
  /// The meshes as sources for load_mesh(); if there are none the experiment makes its own.
  std::vector<std::string> meshes = {};
  std::uint64_t seed = 1;  ///< seed of everything random
  double gap = 1e-6;       ///< width to which R is certified
  std::stop_token stop = {};
  OnProgress on_progress = {};
  /// What readers left out of the meshes.
  std::shared_ptr<LossLog> losses = std::make_shared<LossLog>();
  struct FromPipes {
    std::mutex mutex;
    std::map<std::string, Mesh> meshes;
  };
  std::shared_ptr<FromPipes> from_pipes = std::make_shared<FromPipes>();

  /// Loads a mesh with load_mesh() and records what was left out. A mesh from a pipe is kept, because it can be read
  /// only once. Thread safe.
  Mesh load(const std::string& source) const;
  LoopControl loop() const { return {.stop = stop, .on_progress = on_progress}; }
};

/// A picture that needs no gnuplot: NAME.svg, with its data in NAME.csv.
struct Sheet {
  std::string name, caption;
  report::Csv data;
  std::string svg;
  int width;  ///< natural width in pixels
};

/// The result of an experiment. It depends on settings, meshes and seed alone, except for times where times are
/// the subject.
struct ExperimentResult {
  std::string says;                                  ///< one line: the outcome, and what the paper reports
  Json data = Json::array();                         ///< every number measured, for the JSON file
  std::vector<report::NamedPlot> plots = {};         ///< their names begin with the name of the experiment
  std::vector<Sheet> sheets = {};                    ///< so do theirs
  std::vector<std::vector<std::string>> table = {};  ///< for the page; the first row is its header
  std::string table_says = {};                       ///< what its numbers are
  std::vector<std::string> errors = {};              ///< a line for each mesh that could not be measured
};

/// An experiment. `make` runs it; it throws ParameterError for settings that are not accepted, and Stopped if the
/// context's token is stopped. `help` is the title.
struct Experiment : Factory<ExperimentResult, const ExperimentContext&>::Entry {
  std::string takes;  ///< which meshes it can be given, in a few words; empty if it takes none
  Json quick;         ///< settings with which it takes about a second
};

/// All experiments in the order of the page. A new one is one file in experiments/paper/src/figures/, and one line each
/// in experiments.h there and in experiment.cpp.
const std::vector<Experiment>& experiments();

/// Finds an experiment by its name; throws ParameterError if there is none.
const Experiment& find_experiment(const std::string& name);

struct ExperimentOutcome {
  std::string says;                      ///< see ExperimentResult
  std::vector<std::string> mesh_errors;  ///< a line for each mesh that could not be measured
  std::vector<std::string> losses;       ///< a line for each mesh that is not all that its file holds
  report::PictureTroubles pictures;      ///< what could not be drawn
};

/// Runs an experiment and writes into `folder`, which is made if necessary: NAME.json (settings, seed, meshes,
/// provenance, the line `says` and all data), and for each picture an SVG file, a CSV file and, if it is a plot, a
/// gnuplot file. Meshes and pictures that fail are left out, with a line in the outcome; everything else is written all
/// the same. Throws what Experiment::make() throws (then nothing is written), ParameterError if meshes are given to an
/// experiment that takes none, and std::runtime_error if the folder cannot be written.
ExperimentOutcome run_experiment(const Experiment& experiment, const Json& settings, const ExperimentContext& context,
                                 const std::filesystem::path& folder, const std::string& command_line);

/// Writes index.html with all experiments whose files are in the folder. The page opens from disk and needs no network.
void write_experiment_page(const std::filesystem::path& folder);

}  // namespace rectilin::paper
