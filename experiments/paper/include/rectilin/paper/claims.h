// The paper's claims: a list of them (the ledger), a test of each, and what the tests find.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/base/parameter_error.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::paper {

/// A claim, as papers/claims.json states it; that file is compiled into the library.
struct Claim {
  std::string id;         ///< short name, as in `--claims`
  std::string source;     ///< equation, theorem or figure of the paper
  std::string statement;  ///< what is claimed
  std::string test;       ///< how it is tested, and what its margin is (see Finding)
  double tolerance = 0;   ///< margins no further than this from zero count as zero
  std::string why;        ///< where that tolerance comes from
  std::string code;       ///< path of the test's source, from the root of the project
  bool should_hold = true;
  std::string remark;  ///< what to expect, if that needs explaining; may be empty
};

/// All claims in the order of the ledger. Thread safe.
const std::vector<Claim>& all_claims();

/// The ledger as a table in Markdown: the content of papers/claims.md.
std::string claims_markdown();

/// What one test of a claim found, at the worst place.
struct Finding {
  /// The margin: by how much the claim holds, or, if negative, by how much it is violated.
  double margin = std::numeric_limits<double>::infinity();
  std::string where = {};                 ///< the mesh as a source for load_mesh(); a description if `mesh` is set
  std::shared_ptr<const Mesh> mesh = {};  ///< the mesh itself if no source names it
  Rotation rotation = {};
  std::string note = {};  ///< numbers worth reading, in one line; may be empty
};

enum class ClaimVerdict {
  kFails,            ///< margin < -tolerance
  kHolds,            ///< margin within the tolerance of zero: the claim holds, with equality
  kHoldsWithMargin,  ///< margin > tolerance
  kUntested,         ///< none of the given meshes can test it
};
std::string_view to_string(ClaimVerdict verdict);

struct ClaimResult {
  const Claim* claim = nullptr;
  ClaimVerdict verdict = ClaimVerdict::kUntested;
  Finding decisive;        ///< the finding that the verdict rests on: as a rule the worst
  std::size_t tested = 0;  ///< number of findings
  std::size_t failed = 0;  ///< number of findings that violate the claim by more than the tolerance
};

struct ValidationSettings {
  std::vector<std::string> claims = {};  ///< ids of the claims to test; empty: all
  std::uint64_t seed = 1;
  /// A folder of models and their .cla file, for the claims about retrieval, which otherwise are not tested; and a
  /// folder in which signatures are kept from run to run (if empty they are not kept). `size` is the width and height
  /// of pictures in pixels.
  std::string collection = {}, classes = {}, cache = {};
  int size = 256;
  std::stop_token stop = {};
  /// Called from any thread, one call at a time, with the steps done, the steps in all, and what was done.
  std::function<void(std::size_t, std::size_t, const std::string&)> on_progress = {};
};

struct Validation {
  std::vector<ClaimResult> results;  ///< one for each claim, in the ledger's order
  std::vector<std::string> errors;   ///< a line for each source that could not be read
  std::vector<std::string> losses;   ///< a line for each mesh that is not all that its file holds
  bool complete = true;              ///< false after a stop

  /// Did every claim hold that is expected to?
  bool as_expected() const;
};

/// Tests claims on meshes (sources for load_mesh(), or validation_shapes() if there are none) and, for claims about
/// particular shapes, on those shapes. The result depends on sources, claims and seed but not on the number of threads;
/// only the margins of the claims linear-cost and time-70 are times. Throws ParameterError for an unknown claim and for
/// a collection without classes or the reverse, MeshError for a folder without meshes, std::runtime_error for a
/// collection that cannot be read.
Validation validate(const std::vector<std::string>& sources, const ValidationSettings& settings = {});

/// The built-in shapes that are tested if no mesh is given.
const std::vector<std::string>& validation_shapes();

}  // namespace rectilin::paper
