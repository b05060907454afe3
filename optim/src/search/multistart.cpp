#include "search/multistart.h"

#include <algorithm>

#include "rectilin/optim/restarts.h"

namespace rectilin {

void MultistartOptions::bind(Parameters& table) {
  table.custom(
      "local", "a local optimizer, its settings separated by commas: nelder-mead?size=0.1,restarts=2",
      [this](const Json& value) {
        if (!value.is_string()) return false;
        local = value.get<std::string>();
        return true;
      },
      [this] { return Json(local); }, "method run from each start");
  bind_starts(table, starts, "random starts");
}

Multistart::Multistart(Options options, const Registry& registry) : OptimizerWith(std::move(options)) {
  std::string spec = options_.local;
  std::ranges::replace(spec, ',', '&');
  optimizer_ = registry.make(spec);
  local_ = dynamic_cast<const LocalSearch*>(optimizer_.get());
  if (!local_) throw ParameterError(std::string(kName) + ": '" + options_.local + "' is not a local optimizer");
}

Capabilities Multistart::capabilities() const {
  Capabilities capabilities = optimizer_->capabilities();
  capabilities.uses_random = true;
  capabilities.local = false;
  return capabilities;
}

void Multistart::run(Evaluator& evaluator, const Domain& domain, Random& random) const {
  improve_from_starts(*local_, options_.starts, /*from_incumbent=*/false, evaluator, domain, random);
}

}  // namespace rectilin
