// The plan of a comparison: everything that its results depend on, and nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/optim/registry.h"

namespace rectilin::laboratory {

/// One competitor: an optimizer on a domain.
struct Entry {
  std::string label;   ///< the name it was given, or else the text that was typed; unique in a plan
  std::string spec;    ///< the text that the registry makes it from
  std::string domain;  ///< name of the domain that it searches; empty if it searches none

  bool operator==(const Entry&) const = default;
};

/// The objective of a comparison unless another is named: R(M), for which bounds can be proved.
inline constexpr const char* kRectilinearity = "rectilinearity";

struct Plan {
  std::vector<std::string> meshes;  ///< sources, see load_mesh()
  std::vector<Entry> entries;
  int runs = 15;                 ///< number of runs for each mesh and entry
  std::uint64_t budget = 10000;  ///< evaluations for each run
  std::uint64_t seed = 1;
  std::string certificate = "certify?gap=1e-10";  ///< the optimizer that proves bounds of R for each mesh
  /// What is searched: kRectilinearity, or the name of an objective that ComparisonSettings::objective makes. Nothing
  /// can be proved about the latter. `certificate` is then an optimizer that searches for a good value first, on the
  /// mesh as it is, to measure gaps from.
  std::string objective = kRectilinearity;

  bool proves() const { return objective == kRectilinearity; }

  bool operator==(const Plan&) const = default;
};

/// `LABEL=SPEC`. A text without a label is its own label. An '=' after a '?' belongs to a parameter.
struct LabelledSpec {
  std::string_view label, spec;
};
LabelledSpec split_label(std::string_view text);

/// Reads optimizers separated by commas or blanks, each `[LABEL=]SPEC[@DOMAIN]`. A comma before a number belongs to a
/// value, as in `x?start=1,2,3`. An optimizer that searches a domain but names none gets an entry for each of
/// `domains`; if there are several, its labels name them. Throws ParameterError for an unknown domain or an optimizer
/// that the registry cannot make.
std::vector<Entry> parse_entries(const std::vector<std::string>& lists, const std::vector<std::string>& domains,
                                 const Registry& registry);

/// Throws ParameterError for a plan without meshes, entries or runs; with a mesh or a label that occurs twice or is not
/// UTF-8; or with a `certificate` that proves nothing.
void check(const Plan& plan, const Registry& registry);

Json to_json(const Plan& plan);

/// Throws nlohmann::json::exception if `json` is not what to_json() writes.
Plan plan_from_json(const Json& json);

/// One line that says where two plans first differ.
std::string difference(const Plan& stored, const Plan& asked);

/// An instance of the problem: run k of every optimizer gets the same one. It depends on the arguments of
/// instance() alone.
struct Instance {
  Rotation rotation;       ///< by which the mesh is turned; uniformly distributed
  std::uint64_t run_seed;  ///< seed of the optimizer's random numbers
};
Instance instance(std::uint64_t seed, std::string_view mesh, int run);

}  // namespace rectilin::laboratory
