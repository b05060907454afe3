// Benchmark suites: fixed sets of problems that others can cite, solve with their own programs, and compare.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/laboratory/comparison.h"
#include "rectilin/measure/measure.h"

namespace rectilin::laboratory {

struct SuiteProblem {
  std::string name;       ///< also the name of its file
  std::string source;     ///< see load_mesh()
  std::string landscape;  ///< what makes it easy or hard, in a few words
};

/// A fixed set of problems. Its name ends in a version: a suite never changes, and a changed one gets another version.
struct Suite {
  std::string name, help;
  std::vector<SuiteProblem> problems;
};

/// All suites: `landscapes-1`, built-in shapes with every kind of landscape.
const std::vector<Suite>& suites();

/// Throws ParameterError for an unknown name.
const Suite& suite_by_name(std::string_view name);

/// Your own meshes as a suite, with the names of their files. Throws ParameterError if there are none.
Suite suite_of(const std::vector<std::string>& sources);

/// A problem for programs in any language, as a JSON object with
/// - `format` ("rectilin problem"), `version` (1), `name`, `source`, `digest` (of the mesh), `faces`, `directions`, and
///   `left_out` if the mesh is not all that its file holds;
/// - `vectors`: the area vectors divided by the total area, rows of three numbers. The objective to be minimised over
///   rotations R is value(R) = sum over rows v of |R v|_1, in [1, sqrt(3)];
/// - `rotation`, `value`: the best rotation known and its value; `value_lower`: a proved bound, no rotation has less;
/// - `rectilinearity`, `lower`, `upper`: the same values and bounds as R = 3/value - 2.
Json problem_json(const std::string& name, const std::string& source, const ComparedMesh& mesh,
                  const Rectilinearity& optimum);

/// Writes NAME.json for every problem, with R certified to `gap`, and suite.json, which lists the problems with their
/// digests and bounds. Throws MeshError for a mesh that cannot be measured, std::runtime_error if the folder cannot be
/// written, and Stopped after a stop. Returns a line for each mesh that is not all that its file holds.
std::vector<std::string> export_suite(const Suite& suite, const std::filesystem::path& folder, double gap,
                                      const LoopControl& control = {});

/// Adds runs of other programs to a finished comparison (see run_comparison()), whose page shows them after the next
/// write_report(). `text` has one JSON object a line:
/// - `problem`: a mesh of the comparison, by its source or its title; `optimizer`: a name that no optimizer of the
///   comparison has; `run`: its number, from 0;
/// - `evaluations` and `value`: arrays of the same length, with the best value so far at each evaluation where it fell;
/// - `rotation`: three rows, the rotation of the last value, in the coordinates of the problem's vectors;
/// - `seconds`: an array, optional; `total_evaluations`: optional, by default the last of `evaluations`.
/// Everything that can be checked is checked: evaluations must rise and values fall, no value may be below 1, and the
/// rotation must have the last value (to 1e-9). A run replaces one with the same problem, optimizer and number. Returns
/// how many runs were read. Throws ParameterError, "NAME:line N: reason", and then changes nothing in the folder.
std::size_t add_foreign_runs(const std::filesystem::path& folder, std::string_view text, const std::string& name,
                             const std::function<ComparedMesh(const std::string& mesh)>& load = load_compared_mesh);

}  // namespace rectilin::laboratory
