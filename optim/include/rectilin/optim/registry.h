// Optimizers by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// Makes optimizers from text: `ga`, `ga?population=100&elitism=2`, or a pipeline of several, each
/// starting where the one before it stopped, on what that left of the budget:
/// `super-fibonacci?count=2000+nelder-mead`. A '+' before a letter separates stages; one before a
/// digit belongs to a number. A value type: copy one and add your own.
class Registry {
 public:
  struct Entry {
    std::string name, help;
    /// The registry serves optimizers that are made of others.
    std::function<std::unique_ptr<Optimizer>(const Json& settings, const Registry& registry)> make;
    std::vector<Parameters::Description> parameters;  ///< with their defaults
  };

  /// Adds an optimizer type: `registry.add<GeneticAlgorithm>("one line of help")`. T has a nested
  /// Options with `bind(Parameters&)`, a constructor from Options (or Options and a registry) and a
  /// `kName`.
  template <class T>
  Registry& add(std::string help) {
    using Options = typename T::Options;
    return add(T::kName, std::move(help), Options(), [](Options options, [[maybe_unused]] const Registry& registry) {
      if constexpr (std::is_constructible_v<T, Options, const Registry&>)
        return std::make_unique<T>(std::move(options), registry);
      else return std::make_unique<T>(std::move(options));
    });
  }

  /// Adds one of a family under a name of its own; `construct(options, registry)` makes it from
  /// `defaults` with the settings applied.
  template <class Options, class Construct>
  Registry& add(std::string name, std::string help, const Options& defaults, Construct construct) {
    Options shown = defaults;
    Parameters table;
    shown.bind(table);
    const auto make = [name, defaults, construct](const Json& settings,
                                                  const Registry& registry) -> std::unique_ptr<Optimizer> {
      Options options = defaults;
      Parameters fields;
      options.bind(fields);
      fields.set(settings, name);
      return construct(std::move(options), registry);
    };
    return add({name, std::move(help), make, table.describe()});
  }

  Registry& add(Entry entry);

  /// Throws ParameterError for an unknown name or a setting the optimizer does not accept.
  std::unique_ptr<Optimizer> make(std::string_view spec) const;

  /// The same from a name and settings, such as an optimizer's name() and parameters(). The
  /// settings of a pipeline are an array, one object a stage.
  std::unique_ptr<Optimizer> make(std::string_view name, const Json& settings) const;

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Every optimizer of the library. A new one is one file and one line in registry.cpp.
const Registry& builtin_optimizers();

}  // namespace rectilin
