// The paper's genetic algorithm (section 4.3).
#pragma once

#include "rectilin/optim/method.h"

namespace rectilin {

/// An individual has three chromosomes: binary codes of the three coordinates in the domain's box. Its fitness is
/// 1/value, the paper's S/P. The paper states five numbers (the first five options) and leaves the rest open. For that
/// the defaults are those of the simple genetic algorithm in the textbook (Goldberg 1989, ch. 3): roulette wheel
/// selection, one crossover point for each chromosome, plain binary codes; in addition the best individual survives.
/// papers/genetic.md compares them with the alternatives.
struct GeneticOptions {
  enum class Selection { kRoulette, kTournament, kRank };
  enum class Encoding { kBinary, kGray };

  int population = 50;      ///< N_g
  int generations = 200;    ///< N_gen, the first population included; 0: until the budget ends
  int bits = 20;            ///< L_c, per chromosome
  double crossover = 0.8;   ///< p_c, per pair of parents
  double mutation = 0.005;  ///< p_m, per bit
  Selection selection = Selection::kRoulette;
  int tournament = 2;  ///< individuals in a tournament, if that is the selection
  int points = 1;      ///< crossover points in each chromosome
  Encoding encoding = Encoding::kBinary;
  int elitism = 1;  ///< number of best individuals that are kept unchanged

  void bind(Parameters& table);
  /// Throws ParameterError if elitism leaves no room for offspring.
  void check() const;
};

/// The optimizer `ga`. To choose settings in code: make_optimizer(genetic_algorithm(), options).
GlobalMethod<GeneticOptions> genetic_algorithm();

}  // namespace rectilin
