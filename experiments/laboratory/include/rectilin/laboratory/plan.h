// What a comparison is to do: everything its results depend on, and nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/optim/registry.h"

namespace rectilin::laboratory {

/// One competitor: an optimizer on a domain.
struct Entry {
  std::string label;   ///< as typed, or the name given to it; unique in a plan
  std::string spec;    ///< what the registry makes it from
  std::string domain;  ///< name of the domain it searches, if it searches one

  bool operator==(const Entry&) const = default;
};

/// What a comparison is about if nothing else is said: R(M), of which there are proofs.
inline constexpr const char* kRectilinearity = "rectilinearity";

struct Plan {
  std::vector<std::string> meshes;  ///< sources, see load_mesh()
  std::vector<Entry> entries;
  int runs = 15;                 ///< per mesh and entry
  std::uint64_t budget = 10000;  ///< evaluations a run
  std::uint64_t seed = 1;
  std::string certificate = "certify?gap=1e-10";  ///< what bounds the optimum of each mesh
  /// What is searched: kRectilinearity or the name of an objective that ComparisonSettings::objective makes. Of such an
  /// objective nothing is proved: `certificate` is then a search that runs first, on the mesh as it is.
  std::string objective = kRectilinearity;

  bool proves() const { return objective == kRectilinearity; }

  bool operator==(const Plan&) const = default;
};

/// `LABEL=SPEC`; a text without a label is its own. An '=' behind a '?' belongs to a parameter.
struct LabelledSpec {
  std::string_view label, spec;
};
LabelledSpec split_label(std::string_view text);

/// Reads optimizers separated by commas or blanks, each `[LABEL=]SPEC[@DOMAIN]`. A comma before a
/// number belongs to a value, as in `x?start=1,2,3`. An optimizer that searches a domain and names no
/// domain runs on each of `domains`; with several, its labels say which. Throws ParameterError for what the
/// registry cannot make or an unknown domain.
std::vector<Entry> parse_entries(const std::vector<std::string>& lists, const std::vector<std::string>& domains,
                                 const Registry& registry);

/// Throws ParameterError for a plan without meshes, entries or runs, with a mesh or a label twice or not in UTF-8, or
/// with a certificate that proves nothing.
void check(const Plan& plan, const Registry& registry);

Json to_json(const Plan& plan);

/// Throws nlohmann::json::exception if `json` is not what to_json() writes.
Plan plan_from_json(const Json& json);

/// One line that says where two different plans first differ.
std::string difference(const Plan& stored, const Plan& asked);

/// An instance of the problem: run k of every optimizer gets the same. It depends on the arguments alone.
struct Instance {
  Rotation rotation;       ///< the mesh is turned by it, uniformly distributed
  std::uint64_t run_seed;  ///< seed of the optimizer's random numbers
};
Instance instance(std::uint64_t seed, std::string_view mesh, int run);

}  // namespace rectilin::laboratory
