// A local method from many starts.
#include <algorithm>

#include "rectilin/optim/registry.h"

namespace rectilin {
namespace {

/// A local method from many uniformly random starts. The defaults, thirty runs of Nelder and Mead's method, are how
/// public implementations compute this measure.
struct MultistartOptions {
  std::string local = "nelder-mead";
  int starts = 30;
  void bind(Parameters& table);
};

class Multistart final : public OptimizerWith<MultistartOptions> {
 public:
  /// Throws ParameterError if `local` is not a local optimizer of `registry`.
  Multistart(MultistartOptions options, const Registry& registry);

  std::string name() const override { return "multistart"; }
  Capabilities capabilities() const override;
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;

 private:
  std::shared_ptr<const Optimizer> optimizer_;
  const LocalSearch* local_;  ///< the same object as a local search
};

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

Multistart::Multistart(MultistartOptions options, const Registry& registry) : OptimizerWith(std::move(options)) {
  std::string spec = options_.local;
  std::ranges::replace(spec, ',', '&');
  optimizer_ = registry.make(spec);
  local_ = dynamic_cast<const LocalSearch*>(optimizer_.get());
  if (!local_) throw ParameterError("multistart: '" + options_.local + "' is not a local optimizer");
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

}  // namespace

void add_multistart(Registry& registry) {
  registry.add("multistart", "a local method from many random starts", MultistartOptions(),
               [](MultistartOptions options, const Registry& all) {
                 return std::make_unique<Multistart>(std::move(options), all);
               });
}

}  // namespace rectilin
