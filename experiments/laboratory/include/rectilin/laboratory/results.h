// A finished (or interrupted) comparison, as read back from its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/base/rotation.h"
#include "rectilin/laboratory/plan.h"

namespace rectilin::laboratory {

/// Unit of a run's cost.
enum class Cost { kEvaluations, kSeconds };

/// The gap of a run as a step function of what it has cost so far.
struct Trace {
  double worst = 0;                               ///< the gap before the first evaluation
  std::vector<double> evaluations, seconds, gap;  ///< one element a step; increasing, increasing, decreasing

  const std::vector<double>& cost(Cost unit) const { return unit == Cost::kEvaluations ? evaluations : seconds; }
  double gap_after(Cost unit, double cost) const;
  double final_gap() const { return gap.empty() ? worst : gap.back(); }
  /// Cost until the gap was at most `target`; infinite if it never was.
  double cost_to(Cost unit, double target) const;
};

struct RunResult {
  std::size_t mesh = 0, entry = 0;  ///< indices into the plan
  int run = 0;
  bool failed = false;
  Json record;        ///< the line of runs.jsonl without its trace
  double merit = 0;   ///< R at the best rotation; NaN if there is none
  Rotation rotation;  ///< that rotation in the coordinates of the mesh as it is in its file
  double evaluations = 0, seconds = 0, cpu_seconds = 0;
  Trace trace;

  double spent(Cost unit) const { return unit == Cost::kEvaluations ? evaluations : seconds; }
};

struct MeshResult {
  std::string name;   ///< the source as given
  std::string title;  ///< short, unique in the comparison, without folders and ending
  std::string error;  ///< if it could not be measured: then nothing but the names is set
  std::size_t faces = 0, directions = 0;
  double area = 0;
  double lower = 0, upper = 1;          ///< certified: lower <= R(M) <= upper
  double evaluations = 0, seconds = 0;  ///< what the certificate cost
  Rotation rotation;                    ///< the best known, of R = lower

  /// Width of the certificate, the least gap that is told apart from none; at least kLeastGap.
  double width() const;
};

/// R is a sum over faces: digits beyond this one are rounding.
inline constexpr double kLeastGap = 1e-12;

/// What values of an objective without proof are told apart by: silhouettes are known to within about as much.
inline constexpr double kLeastKnownGap = 1e-6;

struct Results {
  Plan plan;
  std::vector<MeshResult> meshes;  ///< one for each of the plan
  std::vector<RunResult> runs;     ///< by mesh, entry and run, whatever the order they finished in

  /// Runs of an entry on a mesh.
  std::vector<const RunResult*> of(std::size_t mesh, std::size_t entry) const;
};

/// Where add_foreign_runs() keeps runs of other programs, one a line as in runs.jsonl.
inline constexpr const char* kForeignFile = "foreign.jsonl";

/// Is this entry that of another program, and not of the plan as it is stored?
inline bool is_foreign(const Entry& entry) { return entry.domain == "-"; }

/// Short names of sources: file names without folders and endings where that leaves them unique, else the sources.
std::vector<std::string> titles(const std::vector<std::string>& sources);

/// Reads plan.json, meshes.jsonl, runs.jsonl and foreign.jsonl, whose programs are entries behind those of the plan.
/// Gaps are to the certified upper bound of R, so they are never too small, and at least the certificate's width;
/// before its first evaluation a run has the gap of the least R there can be (P <= sqrt(3) S, eq. 12). Of an objective
/// without proof (Plan::proves()) `upper` is the best merit that any run, or the search before them, has found; gaps
/// are to that, and may be too small. Throws std::runtime_error if the folder holds no comparison.
Results load_results(const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
