// Optimizers by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// Makes optimizers from text: `ga`, `ga?population=100&elitism=2`. A value type: copy one and add your own.
class Registry {
 public:
  struct Entry {
    std::string name, help;
    std::function<std::unique_ptr<Optimizer>(const Json& settings)> make;
    std::vector<Parameters::Description> parameters;  ///< with their defaults
  };

  /// Adds an optimizer type: `registry.add<GeneticAlgorithm>("one line of help")`. T has a nested
  /// Options with `bind(Parameters&)`, a constructor from Options and a `kName`.
  template <class T>
  Registry& add(std::string help) {
    typename T::Options defaults;
    Parameters table;
    defaults.bind(table);
    const auto make = [](const Json& settings) -> std::unique_ptr<Optimizer> {
      typename T::Options options;
      Parameters fields;
      options.bind(fields);
      fields.set(settings, T::kName);
      return std::make_unique<T>(options);
    };
    return add({T::kName, std::move(help), make, table.describe()});
  }

  Registry& add(Entry entry);

  /// Throws ParameterError for an unknown name or a setting the optimizer does not accept.
  std::unique_ptr<Optimizer> make(std::string_view spec) const;

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Every optimizer of the library. A new one is one file and one line in registry.cpp.
const Registry& builtin_optimizers();

}  // namespace rectilin
