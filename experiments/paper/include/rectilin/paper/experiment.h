// The paper's figures and what else there is to reproduce: each is a small program with a name,
// from meshes to pictures, their data, and one line that compares with what the paper reports.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/base/factory.h"
#include "rectilin/report/plot.h"

namespace rectilin::paper {

/// What an experiment is run with besides its own settings.
struct ExperimentContext {
  /// Sources, see load_mesh(); if there are none it makes its own.
  std::vector<std::string> meshes = {};
  std::uint64_t seed = 1;  ///< of everything random
  double gap = 1e-6;       ///< width to which R is certified
  std::stop_token stop = {};
  OnProgress on_progress = {};

  LoopControl loop() const { return {.stop = stop, .on_progress = on_progress}; }
};

/// A picture that is made at once: NAME.svg, with NAME.csv.
struct Sheet {
  std::string name, caption;
  report::Csv data;
  std::string svg;
  int width;  ///< natural, in pixels
};

/// What came out. It depends on settings, meshes and seed alone, but for times where times are the
/// subject.
struct ExperimentResult {
  std::string says;                           ///< one line: the outcome beside what the paper reports
  Json data = Json::array();                  ///< every number measured, for the JSON file
  std::vector<report::NamedPlot> plots = {};  ///< the names begin with the experiment's
  std::vector<Sheet> sheets = {};             ///< theirs, too
  std::vector<std::string> errors = {};       ///< a line for each mesh that could not be measured
};

/// `make` runs it: throws ParameterError for settings it does not accept, Stopped if the context's token stops it.
/// `help` is its title.
struct Experiment : Factory<ExperimentResult, const ExperimentContext&>::Entry {
  std::string takes;  ///< meshes it can be given, in a few words; empty if it makes its own only
  Json quick;         ///< settings with which it takes about a second
};

/// Every experiment, in the order of the page. A new one is one file in experiments/paper/src/figures/
/// and one line each in its experiments.h and in experiment.cpp.
const std::vector<Experiment>& experiments();

/// Throws ParameterError for a name that there is not.
const Experiment& find_experiment(const std::string& name);

struct ExperimentOutcome {
  std::string says;                      ///< see ExperimentResult
  std::vector<std::string> mesh_errors;  ///< a line for each mesh that could not be measured
  report::PictureTroubles pictures;      ///< what could not be drawn
};

/// Runs an experiment and writes into `folder`, which is made if need be: NAME.json (settings, seed, meshes,
/// provenance, `says` and all data) and for each picture its CSV, gnuplot (of curves) and SVG files. Meshes and
/// pictures that failed are missing, with a line in the outcome; the rest is written all the same. Throws what
/// Experiment::make() throws (then nothing is written), ParameterError for meshes given to an experiment that takes
/// none, and std::runtime_error if the folder cannot be written.
ExperimentOutcome run_experiment(const Experiment& experiment, const Json& settings, const ExperimentContext& context,
                                 const std::filesystem::path& folder, const std::string& command_line);

/// Writes index.html: all experiments whose files the folder holds. It opens from disk and needs no
/// network.
void write_experiment_page(const std::filesystem::path& folder);

}  // namespace rectilin::paper
