// Optimizers by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/base/factory.h"
#include "rectilin/optim/method.h"

namespace rectilin {

/// Makes optimizers from text: `ga`, `ga?population=100&elitism=2`, or a pipeline of several, each
/// starting where the one before it stopped, on what that left of the budget:
/// `super-fibonacci?count=2000+nelder-mead`. A '+' before a letter separates stages; one before a
/// digit belongs to a number. A value type: copy one and add your own.
///
/// Optimizers are reached by their names. A header of its own is public only where callers need more of one than
/// a RunRecord: certify.h for the proof, genetic.h for the paper's parameters.
class Registry {
 public:
  /// The registry is handed over because some optimizers are made of others.
  using Table = Factory<std::unique_ptr<Optimizer>, const Registry&>;
  using Entry = Table::Entry;

  /// Adds a GlobalMethod or LocalMethod under its name.
  template <class Method>
  Registry& add(Method method) {
    return add(std::move(method), typename Method::Options());
  }

  /// The same with other defaults, for one of a family.
  template <class Method>
  Registry& add(Method method, typename Method::Options defaults) {
    const std::string name = method.name, help = method.help;
    return add(name, help, std::move(defaults), [method](typename Method::Options options, const Registry&) {
      return make_optimizer(method, std::move(options));
    });
  }

  /// Adds any other kind of optimizer: `maker(options, registry)` makes it of `defaults` with the settings applied.
  template <class Options, class Maker>
  Registry& add(std::string name, std::string help, Options defaults, Maker maker) {
    table_.add(std::move(name), std::move(help), std::move(defaults), std::move(maker));
    return *this;
  }

  /// Throws ParameterError for an unknown name or a setting the optimizer does not accept.
  std::unique_ptr<Optimizer> make(std::string_view spec) const;

  /// The same from a name and settings, such as an optimizer's name() and parameters(). The
  /// settings of a pipeline are an array, one object a stage.
  std::unique_ptr<Optimizer> make(std::string_view name, const Json& settings) const;

  const std::vector<Entry>& entries() const { return table_.entries(); }

 private:
  Table table_{"optimizer"};
};

/// The library's own optimizers. A new one is one file, which defines `void add_NAME(Registry&)`, and one line in
/// optim/CMakeLists.txt; those of other libraries are in rectilin/optim/adapters/all_optimizers.h.
const Registry& builtin_optimizers();

}  // namespace rectilin
