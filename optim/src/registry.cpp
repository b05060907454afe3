#include "rectilin/optim/registry.h"

#include <algorithm>

#include "rectilin/optim/genetic.h"
#include "rectilin/optim/grid.h"

namespace rectilin {

Registry& Registry::add(Entry entry) {
  entries_.push_back(std::move(entry));
  return *this;
}

std::unique_ptr<Optimizer> Registry::make(std::string_view text) const {
  const Spec spec = Spec::parse(text);
  const auto entry = std::ranges::find(entries_, spec.name, &Entry::name);
  if (entry == entries_.end()) {
    std::string names;
    for (const Entry& e : entries_) names += (names.empty() ? "" : ", ") + e.name;
    throw ParameterError("no optimizer '" + spec.name + "'; there are " + names);
  }
  return entry->make(spec.settings);
}

const Registry& builtin_optimizers() {
  static const Registry registry = Registry()
      .add<GeneticAlgorithm>("the paper's genetic algorithm (section 4.3): binary chromosomes in a chart's box")
      .add<GridSearch>("exhaustive search of a chart's box, then finer grids round the best points");
  return registry;
}

}  // namespace rectilin
