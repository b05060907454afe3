// Benchmark suites: fixed sets of problems that others can cite, solve with programs of their own, and compare.
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
  std::string name;       ///< also of its file
  std::string source;     ///< see load_mesh()
  std::string landscape;  ///< what makes it easy or hard, in a few words
};

/// The name ends in a version. A suite never changes: what would change it gets another version.
struct Suite {
  std::string name, help;
  std::vector<SuiteProblem> problems;
};

/// `landscapes-1`: built-in shapes of every kind of landscape.
const std::vector<Suite>& suites();

/// Throws ParameterError for an unknown name.
const Suite& suite_by_name(std::string_view name);

/// Meshes of one's own as a suite, named by their files. Throws ParameterError if there is none.
Suite suite_of(const std::vector<std::string>& sources);

/// A problem for programs in any language: an object with
/// - `format` ("rectilin problem"), `version` (1), `name`, `source`, `digest` (of the mesh), `faces`, `directions`;
/// - `vectors`: area vectors over the whole area, rows of three numbers. The objective is to be minimised over
///   rotations R: value(R) = sum over rows v of |R v|_1, in [1, sqrt(3)];
/// - `rotation`, `value`: the best known; `value_lower`: proved, no rotation has less;
/// - `rectilinearity`, `lower`, `upper`: the same as R = 3/value - 2.
Json problem_json(const std::string& name, const std::string& source, const ComparedMesh& mesh,
                  const Rectilinearity& optimum);

/// Writes NAME.json of every problem, certified to `gap`, and suite.json, which lists them with their digests and
/// intervals. Throws MeshError for a mesh that cannot be measured, std::runtime_error if the folder cannot be written.
/// A stop ends it with Stopped.
void export_suite(const Suite& suite, const std::filesystem::path& folder, double gap, const LoopControl& control = {});

/// Adds runs of other programs to a finished comparison (see run_comparison()), whose page shows them from the next
/// write_report() on. `text` has a JSON object a line:
/// - `problem` (a mesh of the comparison, its source or its title), `optimizer` (a name that no optimizer of the
///   comparison has), `run` (from 0);
/// - `evaluations` and `value`: arrays of one length; the best value so far, wherever it fell;
/// - `rotation`: three rows, the one of the last value, in the coordinates of the problem's vectors;
/// - `seconds` (an array, optional), `total_evaluations` (optional; the last of `evaluations` otherwise).
/// Nothing is believed that can be checked: arrays must rise and fall, no value may be below 1, and the rotation must
/// have the last value (to 1e-9). Runs of a problem, optimizer and number that are there already are replaced. Returns
/// how many runs were read. Throws ParameterError, "NAME:line N: reason", and changes nothing in the folder then.
std::size_t add_foreign_runs(const std::filesystem::path& folder, std::string_view text, const std::string& name,
                             const std::function<ComparedMesh(const std::string& mesh)>& load = load_compared_mesh);

}  // namespace rectilin::laboratory
