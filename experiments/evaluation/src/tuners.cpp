// Searches for weights: a genetic algorithm as in the paper, and libraries beside it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "rectilin/base/random.h"
#include "rectilin/evaluation/weights.h"

#ifdef RECTILIN_WITH_NLOPT
#include <nlopt.hpp>
#endif
#ifdef RECTILIN_WITH_PAGMO
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#endif

namespace rectilin::evaluation {
namespace {

using Weights = std::vector<double>;

/// Counts evaluations and remembers the best; past the budget it answers without evaluating.
class Counted {
 public:
  Counted(const std::function<double(const Weights&)>& score, std::size_t budget, std::stop_token stop)
      : score_(score), budget_(budget), stop_(std::move(stop)) {}

  bool over() const { return evaluations_ >= budget_ || stop_.stop_requested(); }

  double operator()(const Weights& weights) {
    if (over()) return 0;
    ++evaluations_;
    const double score = score_(weights);
    if (best_.weights.empty() || score > best_.score) best_ = {weights, score, 0};
    return score;
  }

  Tuned best() const {
    Tuned tuned = best_;
    tuned.evaluations = evaluations_;
    const double largest = tuned.weights.empty() ? 0 : *std::ranges::max_element(tuned.weights);
    if (largest > 0)
      for (double& w : tuned.weights) w /= largest;
    return tuned;
  }

 private:
  const std::function<double(const Weights&)>& score_;
  std::size_t budget_, evaluations_ = 0;
  std::stop_token stop_;
  Tuned best_;
};

Weights random_weights(Random& random, std::size_t terms) {
  Weights weights(terms);
  for (double& w : weights) w = random.uniform();
  return weights;
}

/// Fifty individuals; tournaments of two choose parents, genes are blended (BLX-0.5, Eshelman and Schaffer 1993), each
/// mutates with chance 1/terms, and the best survives.
void genetic(Counted& score, std::size_t terms, Random& random) {
  constexpr std::size_t kPopulation = 50;
  struct Individual {
    Weights weights;
    double fitness;
  };
  std::vector<Individual> population;
  const auto add = [&](std::vector<Individual>& to, Weights weights) {
    const double fitness = score(weights);
    to.push_back({std::move(weights), fitness});
  };
  add(population, Weights(terms, 1));
  while (population.size() < kPopulation) add(population, random_weights(random, terms));
  const auto parent = [&]() -> const Individual& {
    const Individual& a = population[random.below(kPopulation)];
    const Individual& b = population[random.below(kPopulation)];
    return a.fitness >= b.fitness ? a : b;
  };
  while (!score.over()) {
    std::vector<Individual> next{*std::ranges::max_element(population, {}, &Individual::fitness)};
    while (next.size() < kPopulation && !score.over()) {
      const Individual &a = parent(), &b = parent();
      Weights child(terms);
      for (std::size_t i = 0; i < terms; ++i) {
        const double low = std::min(a.weights[i], b.weights[i]), high = std::max(a.weights[i], b.weights[i]);
        const double more = (high - low) / 2;
        double gene = random.uniform(low - more, high + more);
        if (random.chance(1 / static_cast<double>(terms))) gene += 0.1 * random.normal();
        child[i] = std::clamp(gene, 0.0, 1.0);
      }
      add(next, std::move(child));
    }
    if (next.size() < kPopulation) break;
    population = std::move(next);
  }
}

#ifdef RECTILIN_WITH_NLOPT
double nlopt_value(const Weights& weights, Weights&, void* score) { return (*static_cast<Counted*>(score))(weights); }

/// Half of the budget goes to DIRECT-L, which looks everywhere, the rest to Sbplx from the best found: DCG is a step
/// function, so nothing that models slopes will do.
void nlopt_search(Counted& score, std::size_t terms, std::size_t budget, Random&) {
  Weights at(terms, 0.5);
  for (const auto algorithm : {nlopt::GN_DIRECT_L, nlopt::LN_SBPLX}) {
    nlopt::opt search(algorithm, static_cast<unsigned>(terms));
    search.set_lower_bounds(0);
    search.set_upper_bounds(1);
    search.set_max_objective(nlopt_value, &score);
    search.set_maxeval(static_cast<int>(algorithm == nlopt::GN_DIRECT_L ? (budget + 1) / 2 : budget));
    search.set_xtol_rel(1e-4);
    double value = 0;
    try {
      search.optimize(at, value);
    } catch (const std::exception&) {  // it gave up; what it found is in `score`
    }
    if (const Tuned best = score.best(); !best.weights.empty()) at = best.weights;
  }
}
#endif

#ifdef RECTILIN_WITH_PAGMO
struct WeightProblem {
  Counted* score = nullptr;
  std::size_t terms = 1;
  pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {-(*score)(x)}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {Weights(terms, 0), Weights(terms, 1)};
  }
  pagmo::thread_safety get_thread_safety() const { return pagmo::thread_safety::none; }
};

void pagmo_search(Counted& score, std::size_t terms, std::size_t budget, Random& random) {
  constexpr std::size_t kPopulation = 20;
  const pagmo::problem problem{WeightProblem{&score, terms}};
  pagmo::population population{problem, kPopulation, static_cast<unsigned>(random.bits())};
  const auto generations = static_cast<unsigned>(budget / kPopulation);
  pagmo::algorithm search{
      pagmo::cmaes{generations, -1, -1, -1, -1, 0.3, 1e-6, 1e-9, false, true, static_cast<unsigned>(random.bits())}};
  search.evolve(population);
}
#endif

}  // namespace

std::vector<std::string> tuners() {
  std::vector<std::string> names{"ga"};
#ifdef RECTILIN_WITH_NLOPT
  names.emplace_back("nlopt");
#endif
#ifdef RECTILIN_WITH_PAGMO
  names.emplace_back("pagmo");
#endif
  return names;
}

Tuned tune(const std::string& tuner, const std::function<double(const Weights&)>& score, std::size_t terms,
           std::size_t budget, std::uint64_t seed, std::stop_token stop) {
  Counted counted(score, budget, std::move(stop));
  Random random(seed);
  if (tuner == "ga") {
    genetic(counted, terms, random);
    return counted.best();
  }
#ifdef RECTILIN_WITH_NLOPT
  if (tuner == "nlopt") {
    nlopt_search(counted, terms, budget, random);
    return counted.best();
  }
#endif
#ifdef RECTILIN_WITH_PAGMO
  if (tuner == "pagmo") {
    pagmo_search(counted, terms, budget, random);
    return counted.best();
  }
#endif
  throw ParameterError("no tuner '" + tuner + "'");
}

}  // namespace rectilin::evaluation
