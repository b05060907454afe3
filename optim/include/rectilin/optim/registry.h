// Optimizers by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/base/factory.h"
#include "rectilin/optim/method.h"

namespace rectilin {

/// Makes optimizers from text: `ga`, `ga?population=100&elitism=2`, or a pipeline such as
/// `super-fibonacci?count=2000+nelder-mead`, in which each optimizer starts where the one before it stopped, on the
/// rest of the budget. A '+' before a letter separates stages; before a digit it belongs to a number. A value type:
/// copy a registry and add your own.
///
/// Optimizers are used through their names. One has a public header of its own only if callers need more from it than a
/// RunRecord: certify.h for the proof, genetic.h for the paper's parameters.
class Registry {
 public:
  /// Makers get the registry, because some optimizers are made of others.
  using Table = Factory<std::unique_ptr<Optimizer>, const Registry&>;
  using Entry = Table::Entry;

  /// Adds a GlobalMethod or a LocalMethod under its name.
  template <class Method>
  Registry& add(Method method) {
    return add(std::move(method), typename Method::Options());
  }

  /// Likewise with other defaults, for methods that come in variants.
  template <class Method>
  Registry& add(Method method, typename Method::Options defaults) {
    const std::string name = method.name, help = method.help;
    return add(name, help, std::move(defaults), [method](typename Method::Options options, const Registry&) {
      return make_optimizer(method, std::move(options));
    });
  }

  /// Adds any other kind of optimizer: `maker(options, registry)` makes it; its options are `defaults` with the user's
  /// settings applied.
  template <class Options, class Maker>
  Registry& add(std::string name, std::string help, Options defaults, Maker maker) {
    table_.add(std::move(name), std::move(help), std::move(defaults), std::move(maker));
    return *this;
  }

  /// Throws ParameterError for an unknown name or a setting the optimizer does not accept.
  std::unique_ptr<Optimizer> make(std::string_view spec) const;

  /// Likewise from a name and settings, such as an optimizer's name() and parameters(). The settings of a pipeline are
  /// an array with one object for each stage.
  std::unique_ptr<Optimizer> make(std::string_view name, const Json& settings) const;

  const std::vector<Entry>& entries() const { return table_.entries(); }

 private:
  Table table_{"optimizer"};
};

/// The built-in optimizers. A new one is one file, which defines `void add_NAME(Registry&)`, and one line in
/// optim/CMakeLists.txt. Optimizers of other libraries are in rectilin/optim/adapters/all_optimizers.h.
const Registry& builtin_optimizers();

}  // namespace rectilin
