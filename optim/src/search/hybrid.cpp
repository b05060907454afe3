// Genetic search whose individuals are simplices.
#include <algorithm>
#include <vector>

#include "rectilin/optim/allowance.h"
#include "rectilin/optim/registry.h"
#include "search/simplex.h"

namespace rectilin {
namespace {

/// The method of Chang, Gorissen and Melchior (2011) for the smallest box around a solid, here for this objective: a
/// population of simplices of four rotations. The better half breeds, by swapping vertices and by mixing them on the
/// rotation group, and the children mutate by some steps of Nelder and Mead's method. A population that stops improving
/// is replaced by a new one.
struct HybridOptions {
  int evaluations = 0;
  int population = 30;  ///< simplices, M
  int steps = 20;       ///< Nelder-Mead iterations in a generation, K
  int patience = 5;     ///< generations without gain after which a new population is drawn
  double gain = 1e-6;   ///< relative decrease of the value that counts as gain
  void bind(Parameters& table);
};

using Vertices = std::array<Simplex::Vertex, 4>;

Simplex::Vertex vertex(const Rotation& rotation, Evaluator& evaluator) { return {rotation, evaluator.value(rotation)}; }

Simplex random_simplex(Evaluator& evaluator, Random& random) {
  Vertices vertices;
  for (auto& v : vertices) v = vertex(random_rotation(random), evaluator);
  return Simplex(vertices);
}

/// Takes each vertex from one of the parents, more often from the better one.
Simplex swap_vertices(const Simplex& better, const Simplex& worse, Random& random) {
  Vertices vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = (random.chance(0.6) ? better : worse).vertices()[i];
  return Simplex(vertices);
}

/// Puts each vertex 0.6 of the way from the worse parent's to the better parent's.
Simplex mix_vertices(const Simplex& better, const Simplex& worse, Evaluator& evaluator) {
  Vertices vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Rotation& to = better.vertices()[i].rotation;
    const Rotation from = nearest_copy(worse.vertices()[i].rotation, to);
    vertices[i] = vertex(along_geodesic(from, to, 0.6), evaluator);
  }
  return Simplex(vertices);
}

/// Runs a population from its creation until it no longer improves.
void evolve(const HybridOptions& options, const Allowance& allowance, Evaluator& evaluator, Random& random) {
  std::vector<Simplex> population;
  for (int i = 0; i < options.population && !allowance.spent(); ++i)
    population.push_back(random_simplex(evaluator, random));

  double best = std::numeric_limits<double>::infinity();
  for (int idle = 0; idle < options.patience && !allowance.spent();) {
    std::ranges::stable_sort(population, {}, [](const Simplex& s) { return s.best().value; });
    const double value = population.front().best().value;
    idle = value < best * (1 - options.gain) ? 0 : idle + 1;
    best = std::min(best, value);

    const std::size_t half = population.size() / 2;
    const std::vector<Simplex> parents(population.begin(), population.begin() + half);
    for (std::size_t i = 0; i < population.size() && !allowance.spent(); ++i) {
      // The parents are sorted, so of two numbers drawn the lower one is the better parent.
      const auto [a, b] = std::minmax({random.below(half), random.below(half)});
      Simplex child =
          i < half ? swap_vertices(parents[a], parents[b], random) : mix_vertices(parents[a], parents[b], evaluator);
      for (int k = 0; k < options.steps && !allowance.spent(); ++k) child.step(evaluator);
      population[i] = child;
    }
  }
}

void HybridOptions::bind(Parameters& table) {
  Allowance::bind(table, evaluations);
  table.integer("population", population, 2, 1000000, "simplices")
      .integer("steps", steps, 0, 1000000, "Nelder-Mead iterations of each simplex in each generation")
      .integer("patience", patience, 1, 1000000, "generations without gain after which a new population is drawn")
      .real("gain", gain, 0, 1, "relative decrease of the value that counts as gain");
}

void hybrid(const HybridOptions& options, Evaluator& evaluator, const Domain&, Random& random) {
  const Allowance allowance(evaluator, options.evaluations);
  while (!allowance.spent()) evolve(options, allowance, evaluator, random);
}

}  // namespace

void add_hybrid(Registry& registry) {
  registry.add(GlobalMethod<HybridOptions>{
      .name = "hybrid",
      .help = "genetic search with Nelder-Mead steps on rotations (Chang, Gorissen, Melchior 2011)",
      .capabilities = {.uses_domain = false},
      .run = hybrid});
}

}  // namespace rectilin
