// Optimizers made from a struct of settings and a function. The built-in ones are made in this way, and your own
// can be.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "rectilin/optim/local.h"

namespace rectilin {

/// A search among all rotations.
///
///     struct DiceOptions {
///       int throws = 100;
///       void bind(Parameters& table) { table.integer("throws", throws, 1, 1000, "rotations to try"); }
///     };
///     void dice(const DiceOptions& options, Evaluator& evaluator, const Domain&, Random& random) {
///       for (int i = 0; i < options.throws && !evaluator.exhausted(); ++i) evaluator.value(random_rotation(random));
///     }
///     registry.add(GlobalMethod<DiceOptions>{
///         .name = "dice", .help = "random rotations", .capabilities = {.uses_domain = false}, .run = dice});
///
/// If the options have a member `check() const`, it is called with the user's settings; it throws ParameterError for
/// values that are each acceptable but not in combination.
template <class Options_>
struct GlobalMethod {
  using Options = Options_;
  std::string name, help;
  Capabilities capabilities = {};
  /// What Optimizer::run() does.
  void (*run)(const Options& options, Evaluator& evaluator, const Domain& domain, Random& random);
};

/// A local method: a descent from one start, which can be repeated from many.
template <class Options_>
struct LocalMethod {
  using Options = Options_;
  std::string name, help;
  Capabilities capabilities = {};  ///< all but `local`, which follows from `starts`
  /// What LocalSearch::improve() does.
  void (*improve)(const Options& options, const Rotation& start, Evaluator& evaluator, const Domain& domain,
                  Random& random);
  /// The option that holds the number of starts, see improve_from_starts(): first from the incumbent, if there is one,
  /// then from random rotations. If null there is one start.
  int Options::*starts = nullptr;
};

/// The method's options with the given settings; throws ParameterError if it does not accept them.
template <class Options>
Options checked(Options options) {
  if constexpr (requires { options.check(); }) options.check();
  return options;
}

/// A GlobalMethod and its settings as an Optimizer.
template <class Options>
class GlobalOptimizer final : public OptimizerWith<Options> {
 public:
  GlobalOptimizer(GlobalMethod<Options> method, Options options)
      : OptimizerWith<Options>(checked(std::move(options))), method_(std::move(method)) {}

  std::string name() const override { return method_.name; }
  Capabilities capabilities() const override { return method_.capabilities; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override {
    method_.run(this->options_, evaluator, domain, random);
  }

 private:
  GlobalMethod<Options> method_;
};

/// A LocalMethod and its settings as an Optimizer and a LocalSearch.
template <class Options>
class LocalOptimizer final : public OptimizerWith<Options>, public LocalSearch {
 public:
  LocalOptimizer(LocalMethod<Options> method, Options options)
      : OptimizerWith<Options>(checked(std::move(options))), method_(std::move(method)) {}

  std::string name() const override { return method_.name; }
  Capabilities capabilities() const override {
    Capabilities all = method_.capabilities;
    all.local = starts() == 1;
    return all;
  }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override {
    improve_from_starts(*this, starts(), /*from_incumbent=*/true, evaluator, domain, random);
  }
  void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const override {
    method_.improve(this->options_, start, evaluator, domain, random);
  }

 private:
  int starts() const { return method_.starts ? this->options_.*method_.starts : 1; }

  LocalMethod<Options> method_;
};

/// Makes the optimizer with these settings.
template <class Options>
std::unique_ptr<Optimizer> make_optimizer(GlobalMethod<Options> method, std::type_identity_t<Options> options = {}) {
  return std::make_unique<GlobalOptimizer<Options>>(std::move(method), std::move(options));
}
template <class Options>
std::unique_ptr<Optimizer> make_optimizer(LocalMethod<Options> method, std::type_identity_t<Options> options = {}) {
  return std::make_unique<LocalOptimizer<Options>>(std::move(method), std::move(options));
}

}  // namespace rectilin
