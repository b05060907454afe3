// A comparison, finished or interrupted, read back from its folder.
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

/// The gap of a run as a step function of its cost so far.
struct Trace {
  double worst = 0;  ///< the gap before the first evaluation
  std::vector<double> evaluations, seconds,
      gap;  ///< one element for each step; the first two increase, the gap decreases

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
  Json record;        ///< the run's line in runs.jsonl, without the trace
  double merit = 0;   ///< R at the best rotation; NaN if there is none
  Rotation rotation;  ///< the best rotation, in the coordinates of the mesh's file
  double evaluations = 0, seconds = 0, cpu_seconds = 0;
  Trace trace;

  double spent(Cost unit) const { return unit == Cost::kEvaluations ? evaluations : seconds; }
};

struct MeshResult {
  std::string name;      ///< the source as given
  std::string title;     ///< a short name, unique in the comparison: no folders, no extension
  std::string error;     ///< why it could not be measured; then only the names are set
  std::string left_out;  ///< what its reader left out, if anything
  std::size_t faces = 0, directions = 0;
  double area = 0;
  double lower = 0, upper = 1;          ///< certified: lower <= R(M) <= upper
  double evaluations = 0, seconds = 0;  ///< what the proof of the bounds cost
  Rotation rotation;                    ///< the best rotation known; it attains R = lower

  /// The width of the bounds, which is the smallest gap that can be told from none; at least kLeastGap.
  double width() const;
};

/// R is computed from sums over faces: differences below this are rounding.
inline constexpr double kLeastGap = 1e-12;

/// The same for objectives without a proof: areas of silhouettes are known to about this.
inline constexpr double kLeastKnownGap = 1e-6;

struct Results {
  Plan plan;
  std::vector<MeshResult> meshes;  ///< one for each mesh of the plan
  std::vector<RunResult> runs;     ///< sorted by mesh, entry and run

  /// The runs of an entry on a mesh.
  std::vector<const RunResult*> of(std::size_t mesh, std::size_t entry) const;
};

/// The file in which add_foreign_runs() keeps the runs of other programs, one a line as in runs.jsonl.
inline constexpr const char* kForeignFile = "foreign.jsonl";

/// Does the entry stand for another program? The stored plan does not contain such entries.
inline bool is_foreign(const Entry& entry) { return entry.domain == "-"; }

/// Short names of sources: file names without folders and extensions where these are unique, otherwise the sources.
std::vector<std::string> titles(const std::vector<std::string>& sources);

/// Reads plan.json, meshes.jsonl, runs.jsonl and foreign.jsonl; the programs of the latter are entries after those of
/// the plan. A gap is the distance to the certified upper bound of R, so it is never too small, and it is at least the
/// width of the bounds. Before its first evaluation a run has the gap of the least possible R (P <= sqrt(3) S, eq. 12).
/// For an objective without proof (see Plan::proves()) `upper` is the best merit that any run, or the search before
/// them, has found. Gaps are then distances to that and may be too small. Throws std::runtime_error if the folder holds
/// no comparison.
Results load_results(const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
