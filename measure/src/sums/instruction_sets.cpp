// Lists the instruction sets, and restricts the library to one of them.
#include <stdexcept>

#include "hwy/highway.h"
#include "rectilin/measure/flat_sum.h"

namespace rectilin {
namespace {

void use_targets(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);  // zero means all
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    names.emplace_back(hwy::TargetName(target));
  }
  return names;
}

ScopedInstructionSet::ScopedInstructionSet(std::string_view name) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name != hwy::TargetName(target)) continue;
    use_targets(target);
    return;
  }
  throw std::invalid_argument("instruction set " + std::string(name) + " is not available");
}

ScopedInstructionSet::~ScopedInstructionSet() { use_targets(0); }

}  // namespace rectilin
