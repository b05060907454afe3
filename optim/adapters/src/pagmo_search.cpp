// pagmo as an optimizer of this project.
#include <algorithm>
#include <optional>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/bee_colony.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/compass_search.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/gwo.hpp>
#include <pagmo/algorithms/ihs.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/pso_gen.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/allowance.h"
#include "rectilin/optim/local.h"

namespace rectilin {
namespace {

/// What an algorithm is built from; everything else has pagmo's defaults.
struct Plan {
  unsigned generations;
  unsigned population;
  unsigned evaluations;
  unsigned seed;
};

struct PagmoAlgorithm {
  const char* name;
  const char* help;
  int population;  ///< the default size
  pagmo::algorithm (*make)(const Plan&);
  bool local = false;
};

constexpr PagmoAlgorithm kAlgorithms[] = {
    {"gaco", "ant colony (Schlueter et al. 2009)", 63,
     [](const Plan& p) {
       constexpr unsigned kNever = 4000000000u;  // its own limits on evaluations: never reached
       return pagmo::algorithm(
           pagmo::gaco(p.generations, std::min(63u, p.population), 1, 0, 0.01, 1, 7, kNever, kNever, 0, false, p.seed));
     }},
    {"pso", "particle swarm (Poli et al. 2007)", 20,
     [](const Plan& p) {
       return pagmo::algorithm(pagmo::pso(p.generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, p.seed));
     }},
    {"pso_gen", "particle swarm, moved a generation at a time", 20,
     [](const Plan& p) {
       return pagmo::algorithm(pagmo::pso_gen(p.generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, p.seed));
     }},
    {"sade", "self-adaptive differential evolution (Brest et al. 2006)", 20,
     [](const Plan& p) { return pagmo::algorithm(pagmo::sade(p.generations, 2, 1, 1e-12, 1e-9, false, p.seed)); }},
    {"sga", "genetic algorithm on real numbers, not the paper's", 50,
     [](const Plan& p) {
       return pagmo::algorithm(
           pagmo::sga(p.generations, 0.9, 1, 0.02, 1, 2, "exponential", "polynomial", "tournament", p.seed));
     }},
    {"de", "differential evolution (Storn and Price 1997)", 20,
     [](const Plan& p) { return pagmo::algorithm(pagmo::de(p.generations, 0.8, 0.9, 2, 1e-12, 1e-9, p.seed)); }},
    {"de1220", "differential evolution that picks its variant (Izzo)", 20,
     [](const Plan& p) {
       return pagmo::algorithm(
           pagmo::de1220(p.generations, {2, 3, 7, 10, 13, 14, 15, 16}, 1, 1e-12, 1e-9, false, p.seed));
     }},
    {"cmaes", "covariance matrix adaptation (Hansen 2006)", 20,
     [](const Plan& p) {
       return pagmo::algorithm(pagmo::cmaes(p.generations, -1, -1, -1, -1, 0.5, 1e-12, 1e-9, false, true, p.seed));
     }},
    {"xnes", "exponential natural evolution strategy (Glasmachers et al. 2010)", 20,
     [](const Plan& p) {
       return pagmo::algorithm(pagmo::xnes(p.generations, -1, -1, -1, -1, 1e-12, 1e-9, false, true, p.seed));
     }},
    {"simulated_annealing", "simulated annealing (Corana et al. 1987)", 1,
     [](const Plan& p) {
       constexpr unsigned kBin = 10, kMoves = 3 * kBin;  // one coordinate after another, three in all
       // pagmo's default temperatures suit values of the order of ten; the values of this objective differ
       // by hundredths.
       return pagmo::algorithm(
           pagmo::simulated_annealing(0.05, 1e-8, std::max(1u, p.evaluations / kMoves), 1, kBin, 0.5, p.seed));
     }},
    {"bee_colony", "artificial bee colony (Karaboga and Basturk 2007)", 20,
     [](const Plan& p) { return pagmo::algorithm(pagmo::bee_colony(std::max(1u, p.generations / 2), 20, p.seed)); }},
    {"gwo", "grey wolf optimizer (Mirjalili et al. 2014)", 20,
     [](const Plan& p) { return pagmo::algorithm(pagmo::gwo(std::max(3u, p.generations), p.seed)); }},
    {"ihs", "improved harmony search (Mahdavi et al. 2007)", 20,
     [](const Plan& p) { return pagmo::algorithm(pagmo::ihs(p.evaluations, 0.85, 0.35, 0.99, 1e-5, 1, p.seed)); }},
    {"compass_search", "compass search (Kolda, Lewis, Torczon 2003); local", 1,
     [](const Plan& p) { return pagmo::algorithm(pagmo::compass_search(p.evaluations, 0.1, 1e-9, 0.5)); }, true},
};

struct PagmoOptions {
  const PagmoAlgorithm* algorithm;
  int population;
  int generations = 0;
  int evaluations = 0;

  void bind(Parameters& table) {
    Allowance::bind(table, evaluations);
    if (population == 1) return;
    table.integer("population", population, 8, 1000000, "individuals")
        .integer("generations", generations, 0, 1000000000,
                 "generations of a population; 0: as many as the budget allows");
  }
};

/// Thrown when the allowance is spent, to leave the library's loops.
struct Spent {};

/// The objective as pagmo sees it: a problem that may be copied.
struct BoxProblem {
  Evaluator* evaluator = nullptr;
  const Domain* domain = nullptr;
  const Allowance* allowance = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    if (allowance->spent()) throw Spent();
    return {evaluator->value(domain->rotation(Eigen::Vector3d(x.data())))};
  }

  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const Eigen::Vector3d lower = domain->lower(), upper = domain->upper();
    return {{lower.begin(), lower.end()}, {upper.begin(), upper.end()}};
  }
};

class PagmoSearch : public OptimizerWith<PagmoOptions> {
 public:
  using OptimizerWith::OptimizerWith;

  std::string name() const override { return "pagmo:" + std::string(options_.algorithm->name); }
  Capabilities capabilities() const override { return {.local = options_.algorithm->local}; }

  /// A population that has converged is replaced by a new one, as long as the budget lasts.
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override {
    const Allowance allowance(evaluator, options_.evaluations);
    std::optional<Rotation> start;
    if (evaluator.has_incumbent()) start = evaluator.incumbent().rotation;
    for (int round = 0; !allowance.spent(); ++round, start.reset())
      evolve({&evaluator, &domain, &allowance}, allowance.plan(round), start, random);
  }

 protected:
  /// Evolves one population. pagmo plans its schedules for `length` evaluations.
  void evolve(const BoxProblem& problem, std::uint64_t length, const std::optional<Rotation>& start,
              Random& random) const {
    const auto left = static_cast<unsigned>(std::min<std::uint64_t>(length, 1000000000));
    const auto size = static_cast<unsigned>(options_.population);
    const unsigned generations =
        options_.generations > 0 ? static_cast<unsigned>(options_.generations) : std::max(1u, left / size);
    const auto seed = [&] { return static_cast<unsigned>(random.bits()); };
    try {
      pagmo::population population(problem, start ? size - 1 : size, seed());
      if (start) {
        const Eigen::Vector3d x = problem.domain->coordinates(*start);
        population.push_back(pagmo::vector_double(x.begin(), x.end()));
      }
      options_.algorithm->make({generations, size, left, seed()}).evolve(population);
    } catch (const Spent&) {
    }
  }
};

class PagmoLocal final : public PagmoSearch, public LocalSearch {
 public:
  using PagmoSearch::PagmoSearch;

  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override {
    improve(start_of(evaluator, random), evaluator, domain, random);
  }

  void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const override {
    const Allowance allowance(evaluator, options_.evaluations);
    evolve({&evaluator, &domain, &allowance}, allowance.plan(0), start, random);
  }
};

std::unique_ptr<Optimizer> make_pagmo(PagmoOptions options, const Registry&) {
  if (options.algorithm->local) return std::make_unique<PagmoLocal>(std::move(options));
  return std::make_unique<PagmoSearch>(std::move(options));
}

}  // namespace

void add_pagmo(Registry& registry) {
  for (const PagmoAlgorithm& algorithm : kAlgorithms)
    registry.add("pagmo:" + std::string(algorithm.name), algorithm.help,
                 PagmoOptions{.algorithm = &algorithm, .population = algorithm.population}, make_pagmo);
}

}  // namespace rectilin
