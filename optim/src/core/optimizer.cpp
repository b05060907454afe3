#include "rectilin/optim/optimizer.h"

namespace rectilin {
namespace {

struct Flag {
  const char* name;
  bool Capabilities::*member;
  bool of_all = false;  ///< a combination has it only if all parts have it
};

constexpr Flag kFlags[] = {{"deterministic", &Capabilities::deterministic, true},
                           {"uses_domain", &Capabilities::uses_domain},
                           {"uses_random", &Capabilities::uses_random},
                           {"batches", &Capabilities::batches},
                           {"needs_cuts", &Capabilities::needs_cuts},
                           {"needs_smooth", &Capabilities::needs_smooth},
                           {"needs_turns", &Capabilities::needs_turns},
                           {"certifies", &Capabilities::certifies},
                           {"local", &Capabilities::local, true}};

}  // namespace

Json to_json(const Capabilities& capabilities) {
  Json flags = Json::object();
  for (const Flag& flag : kFlags) flags[flag.name] = capabilities.*flag.member;
  return flags;
}

Capabilities together(const Capabilities& a, const Capabilities& b) {
  Capabilities whole;
  for (const Flag& flag : kFlags) {
    const bool first = a.*flag.member, second = b.*flag.member;
    whole.*flag.member = flag.of_all ? first && second : first || second;
  }
  return whole;
}

void require_needs(const Optimizer& optimizer, const Objective& objective) {
  const auto require = [&](bool needed, bool offered, const char* what) {
    if (needed && !offered) throw ParameterError(optimizer.name() + ": '" + objective.name() + "' has no " + what);
  };
  const Capabilities needs = optimizer.capabilities();
  require(needs.needs_cuts, objective.has_cuts(), "cuts");
  require(needs.needs_smooth, objective.has_smooth(), "smooth surrogate");
  require(needs.needs_turns, objective.has_turns(), "best turns");
}

}  // namespace rectilin
