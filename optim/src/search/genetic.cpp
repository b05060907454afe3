#include "rectilin/optim/genetic.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "rectilin/optim/allowance.h"
#include "rectilin/optim/registry.h"

namespace rectilin {
namespace {

using Chromosome = std::uint32_t;
using Individual = std::array<Chromosome, 3>;

/// A population with its values, and the rules that breed the next one.
class Breeder {
 public:
  Breeder(const GeneticOptions& options, Random& random) : options_(options), random_(random) {
    const std::uint64_t codes = std::uint64_t{1} << options.bits;
    population_.resize(options.population);
    for (Individual& individual : population_)
      for (Chromosome& code : individual) code = static_cast<Chromosome>(random.below(codes));
  }

  void evaluate(Evaluator& evaluator, const Domain& domain) {
    rotations_.clear();
    for (const Individual& individual : population_) rotations_.push_back(decode(individual, domain));
    values_.resize(population_.size());
    evaluator.values(rotations_, values_);
    rank();
  }

  void breed() {
    std::vector<Individual> next;
    next.reserve(population_.size() + 1);
    for (int i = 0; i < options_.elitism; ++i) next.push_back(population_[order_[i]]);
    while (next.size() < population_.size()) {
      Individual a = population_[select()], b = population_[select()];
      if (random_.chance(options_.crossover)) cross(a, b);
      mutate(a);
      mutate(b);
      next.push_back(a);
      next.push_back(b);
    }
    next.resize(population_.size());
    population_ = std::move(next);
  }

 private:
  Rotation decode(const Individual& individual, const Domain& domain) const {
    const double scale = 1.0 / static_cast<double>((std::uint64_t{1} << options_.bits) - 1);
    Eigen::Vector3d t;
    for (int k = 0; k < 3; ++k) {
      Chromosome code = individual[k];
      if (options_.encoding == GeneticOptions::Encoding::kGray)
        for (int shift = 1; shift < options_.bits; shift *= 2) code ^= code >> shift;
      t[k] = code * scale;
    }
    return domain.from_unit(t);
  }

  /// Sorts indices from best to worst, and prepares the roulette wheel of the selection.
  void rank() {
    order_.resize(population_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::stable_sort(order_, {}, [this](int i) { return values_[i]; });
    if (options_.selection == GeneticOptions::Selection::kTournament) return;
    wheel_.resize(population_.size());
    for (std::size_t place = 0; place < order_.size(); ++place)
      wheel_[order_[place]] = options_.selection == GeneticOptions::Selection::kRank
                                  ? static_cast<double>(order_.size() - place)
                                  : 1.0 / values_[order_[place]];
    std::partial_sum(wheel_.begin(), wheel_.end(), wheel_.begin());
  }

  int select() {
    if (options_.selection == GeneticOptions::Selection::kTournament) {
      int best = static_cast<int>(random_.below(population_.size()));
      for (int i = 1; i < options_.tournament; ++i) {
        const int rival = static_cast<int>(random_.below(population_.size()));
        if (values_[rival] < values_[best]) best = rival;
      }
      return best;
    }
    const double spin = random_.uniform() * wheel_.back();
    const auto at = std::ranges::upper_bound(wheel_, spin);
    return static_cast<int>(std::min(at - wheel_.begin(), std::ssize(wheel_) - 1));
  }

  /// Crosses two individuals: each pair of chromosomes swaps its tails behind `points` random places.
  void cross(Individual& a, Individual& b) {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < options_.points; ++i) {
        const auto cut = 1 + random_.below(static_cast<std::uint64_t>(options_.bits - 1));
        const Chromosome tail = (Chromosome{1} << cut) - 1;
        const Chromosome difference = (a[k] ^ b[k]) & tail;
        a[k] ^= difference;
        b[k] ^= difference;
      }
  }

  void mutate(Individual& individual) {
    for (Chromosome& code : individual)
      for (int bit = 0; bit < options_.bits; ++bit)
        if (random_.chance(options_.mutation)) code ^= Chromosome{1} << bit;
  }

  const GeneticOptions& options_;
  Random& random_;
  std::vector<Individual> population_;
  std::vector<Rotation> rotations_;
  std::vector<double> values_;
  std::vector<int> order_;
  std::vector<double> wheel_;
};

void search(const GeneticOptions& options, Evaluator& evaluator, const Domain& domain, Random& random) {
  Breeder breeder(options, random);
  const Allowance allowance(evaluator, 0);
  const bool endless = options.generations == 0;
  breeder.evaluate(evaluator, domain);
  for (int generation = 1; endless ? !allowance.spent() : generation < options.generations && !evaluator.exhausted();
       generation += !endless) {
    breeder.breed();
    breeder.evaluate(evaluator, domain);
  }
}

}  // namespace

void GeneticOptions::bind(Parameters& table) {
  table.integer("population", population, 2, 1000000, "individuals, N_g")
      .integer("generations", generations, 0, 1000000000,
               "generations, N_gen, the first included; 0: until the budget ends")
      .integer("bits", bits, 2, 31, "bits of a chromosome, L_c")
      .real("crossover", crossover, 0, 1, "probability that a pair is crossed, p_c")
      .real("mutation", mutation, 0, 1, "probability that a bit is flipped, p_m")
      .choice("selection", selection,
              {{"roulette", Selection::kRoulette}, {"tournament", Selection::kTournament}, {"rank", Selection::kRank}},
              "how parents are chosen")
      .integer("tournament", tournament, 1, 1000, "individuals in a tournament, if that is the selection")
      .integer("points", points, 1, 31, "crossover points in each chromosome")
      .choice("encoding", encoding, {{"binary", Encoding::kBinary}, {"gray", Encoding::kGray}},
              "how chromosomes code numbers")
      .integer("elitism", elitism, 0, 1000000, "number of best individuals that are kept unchanged");
}

void GeneticOptions::check() const {
  if (elitism >= population)
    throw ParameterError("ga: elitism=" + std::to_string(elitism) + " leaves no room in a population of " +
                         std::to_string(population));
}

GlobalMethod<GeneticOptions> genetic_algorithm() {
  return {.name = "ga",
          .help = "the paper's genetic algorithm (section 4.3): binary chromosomes in a domain's box",
          .capabilities = {.batches = true},
          .run = search};
}

void add_genetic(Registry& registry) { registry.add(genetic_algorithm()); }

}  // namespace rectilin
