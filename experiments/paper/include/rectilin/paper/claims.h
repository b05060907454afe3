// The paper's claims: the ledger of them, a test of each, and what the tests find.
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

/// An entry of papers/claims.json, which is compiled into the library.
struct Claim {
  std::string id;         ///< short name, as in `--claims`
  std::string source;     ///< equation, theorem or figure of the paper
  std::string statement;  ///< what is claimed
  std::string test;       ///< how it is tested, and what the margin is
  double tolerance = 0;   ///< how far from zero a margin may be and still count as zero
  std::string why;        ///< where that tolerance comes from
  std::string code;       ///< the file with the test, from the project's root
  bool should_hold = true;
  std::string remark;  ///< what is to be expected, where that takes words; may be empty
};

/// All claims, in the ledger's order. Thread safe.
const std::vector<Claim>& all_claims();

/// The ledger as a table in Markdown: what papers/claims.md holds.
std::string claims_markdown();

/// What one test of a claim found at its worst place.
struct Finding {
  /// Room between what was seen and what the claim allows; negative if it is violated, by so much.
  double margin = std::numeric_limits<double>::infinity();
  std::string where = {};                 ///< the mesh: a source for load_mesh(), or words if `mesh` is set
  std::shared_ptr<const Mesh> mesh = {};  ///< the mesh itself if no source names it
  Rotation rotation = {};
  std::string note = {};  ///< figures worth reading, one line; may be empty
};

enum class ClaimVerdict {
  kFails,            ///< margin < -tolerance
  kHolds,            ///< margin within the tolerance of zero: the claim holds and is attained
  kHoldsWithMargin,  ///< margin > tolerance
  kUntested,         ///< nothing that it applies to was given
};
std::string_view to_string(ClaimVerdict verdict);

struct ClaimResult {
  const Claim* claim = nullptr;
  ClaimVerdict verdict = ClaimVerdict::kUntested;
  Finding decisive;        ///< the finding with the margin the verdict rests on: as a rule the worst
  std::size_t tested = 0;  ///< findings
  std::size_t failed = 0;  ///< of them, beyond the tolerance
};

struct ValidationSettings {
  std::vector<std::string> claims = {};  ///< ids; empty: all
  std::uint64_t seed = 1;
  /// A folder of models and their .cla file, for the claims about retrieval, which are untested without; and a folder
  /// in which signatures are kept from run to run (none: they are not kept). `size`: pixels in a row of a picture.
  std::string collection = {}, classes = {}, cache = {};
  int size = 256;
  std::stop_token stop = {};
  /// Called from any thread, one at a time: steps done, steps in all, what was done.
  std::function<void(std::size_t, std::size_t, const std::string&)> on_progress = {};
};

struct Validation {
  std::vector<ClaimResult> results;  ///< one for each claim, in the ledger's order
  std::vector<std::string> errors;   ///< a line for each source that could not be read
  bool complete = true;              ///< false after a stop

  /// Did every claim hold that should?
  bool as_expected() const;
};

/// Tests claims on meshes (sources for load_mesh(); without any, on validation_shapes()) and, where
/// a claim is about certain shapes, on those. The result depends on sources, claims and seed, not
/// on threads; the margins of linear-cost and time-70 alone are times. Throws ParameterError for an
/// unknown claim and for a collection without classes or the reverse, MeshError for a folder without meshes,
/// std::runtime_error for a collection that cannot be read.
Validation validate(const std::vector<std::string>& sources, const ValidationSettings& settings = {});

/// The built-in shapes that stand in where no mesh is given.
const std::vector<std::string>& validation_shapes();

}  // namespace rectilin::paper
