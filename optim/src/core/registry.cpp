#include "rectilin/optim/registry.h"

#include <algorithm>

#include "core/pipeline.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/grid.h"
#include "search/anneal.h"
#include "search/axis_sweep.h"
#include "search/hybrid.h"
#include "search/multistart.h"
#include "search/nelder_mead.h"
#include "search/random_search.h"
#include "search/super_fibonacci.h"

namespace rectilin {
namespace {

std::vector<std::string> split_stages(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::vector<std::string> stages(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '+' && i + 1 < text.size() && is_letter(text[i + 1])) stages.emplace_back();
    else stages.back() += text[i];
  }
  return stages;
}

std::unique_ptr<Optimizer> in_a_row(std::vector<std::unique_ptr<const Optimizer>> stages) {
  return std::make_unique<Pipeline>(std::move(stages));
}

}  // namespace

Registry& Registry::add(Entry entry) {
  entries_.push_back(std::move(entry));
  return *this;
}

std::unique_ptr<Optimizer> Registry::make(std::string_view text) const {
  const std::vector<std::string> specs = split_stages(text);
  if (specs.size() == 1) {
    const Spec spec = Spec::parse(text);
    return make(spec.name, spec.settings);
  }
  std::vector<std::unique_ptr<const Optimizer>> stages;
  for (const std::string& spec : specs) stages.push_back(make(spec));
  return in_a_row(std::move(stages));
}

std::unique_ptr<Optimizer> Registry::make(std::string_view name, const Json& settings) const {
  const std::vector<std::string> names = split_stages(name);
  if (names.size() > 1) {
    if (!settings.is_array() || settings.size() != names.size())
      throw ParameterError(std::string(name) + ": its settings are an array, one object a stage");
    std::vector<std::unique_ptr<const Optimizer>> stages;
    for (std::size_t i = 0; i < names.size(); ++i) stages.push_back(make(names[i], settings[i]));
    return in_a_row(std::move(stages));
  }
  const auto entry = std::ranges::find(entries_, name, &Entry::name);
  if (entry == entries_.end()) {
    std::string known;
    for (const Entry& e : entries_) known += (known.empty() ? "" : ", ") + e.name;
    throw ParameterError("no optimizer '" + std::string(name) + "'; there are " + known);
  }
  return entry->make(settings, *this);
}

const Registry& builtin_optimizers() {
  static const Registry registry = [] {
    Registry all;
    all.add<GeneticAlgorithm>("the paper's genetic algorithm (section 4.3): binary chromosomes in a domain's box")
        .add<Certify>("branch and bound with a proof: the global minimum to within a gap")
        .add<GridSearch>("exhaustive search of a domain's box, then finer grids round the best points")
        .add<RandomSearch>("uniformly random rotations")
        .add<SuperFibonacci>("evenly spread rotations (Alexa 2022)")
        .add<Annealing>("simulated annealing on rotations, with a step length that adapts")
        .add<NelderMead>("Nelder and Mead's simplex method on rotations; local")
        .add<AxisSweep>("exact coordinate descent: best turns about the frame's axes, one after the other")
        .add<Multistart>("a local method from many random starts")
        .add<HybridSearch>("genetic search with Nelder-Mead steps on rotations (Chang, Gorissen, Melchior 2011)");
    return all;
  }();
  return registry;
}

}  // namespace rectilin
