// Simulated annealing.
#include <algorithm>
#include <cmath>

#include "rectilin/optim/allowance.h"
#include "rectilin/optim/registry.h"
#include "search/turned.h"

namespace rectilin {
namespace {

/// Simulated annealing (Kirkpatrick, Gelatt, Vecchi 1983) with random turns of the frame. Temperatures are relative to
/// the spread of the objective over random rotations, so that the same settings suit every mesh. The length of the
/// turns adapts to the share of moves that are accepted (as in Corana et al. 1987). If only a time limit is set, it
/// anneals again and again, each time for twice as long (Allowance::plan()), continuing from the incumbent.
struct AnnealingOptions {
  enum class Cooling { kGeometric, kLinear, kFast, kBoltzmann };
  enum class Reheat { kBest, kRandom };

  int evaluations = 0;
  Cooling cooling = Cooling::kGeometric;
  double hot = 0.5;    ///< first temperature, in standard deviations of the objective
  double cold = 1e-7;  ///< last temperature, likewise
  int cycles = 4;      ///< number of coolings, which share the evaluations
  Reheat reheat = Reheat::kRandom;
  double acceptance = 0.4;  ///< the step length adapts so that this share of moves is accepted
  double step = 0.5;        ///< first and longest step: standard deviation (radians) of each component of a turn

  void bind(Parameters& table);
  void check() const;  ///< throws if the last temperature is above the first
};

struct State {
  Rotation rotation;
  double value;
};

/// Evaluates random rotations to find the scale of the objective and the first start.
struct Survey {
  State best;
  double deviation;
};

Survey survey(const Allowance& allowance, Evaluator& evaluator, Random& random) {
  constexpr int kCount = 32;
  Survey result{{Rotation(), std::numeric_limits<double>::infinity()}, 0};
  double mean = 0, squares = 0;  // Welford's recurrence
  for (int i = 0; i < kCount && !allowance.spent(); ++i) {
    const Rotation rotation = random_rotation(random);
    const double value = evaluator.value(rotation);
    if (value < result.best.value) result.best = {rotation, value};
    const double off = value - mean;
    mean += off / (i + 1);
    squares += off * (value - mean);
  }
  result.deviation = std::sqrt(squares / (kCount - 1));
  return result;
}

/// The temperature after the fraction t of a cooling, from 1 at t = 0 to `end` at t = 1.
double temperature(AnnealingOptions::Cooling cooling, double t, double end) {
  using Cooling = AnnealingOptions::Cooling;
  switch (cooling) {
    case Cooling::kGeometric:
      return std::pow(end, t);
    case Cooling::kLinear:
      return 1 + t * (end - 1);
    case Cooling::kFast:
      return 1 / (1 + t * (1 / end - 1));  // 1/k: Szu and Hartley 1987
    case Cooling::kBoltzmann:              // 1/log k: Geman and Geman 1984
      return 1 / (1 + (1 / end - 1) * std::log1p(1000 * t) / std::log1p(1000.0));
  }
  return end;
}

/// One cooling of `moves` evaluations that starts from `state`.
void cool(const AnnealingOptions& options, State state, double hot, std::uint64_t moves, Evaluator& evaluator,
          Random& random) {
  double step = options.step;
  for (std::uint64_t i = 0; i < moves && !evaluator.exhausted(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(moves);
    const double heat = hot * temperature(options.cooling, t, options.cold / options.hot);
    const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
    const Rotation moved = turned(state.rotation, step * turn);
    const State next{moved, evaluator.value(moved)};
    const double rise = next.value - state.value;
    const bool accepted = rise <= 0 || random.chance(std::exp(-rise / heat));
    if (accepted) state = next;
    // Steps grow by (1-a) when a move is accepted and shrink by a when it is not: in balance if the share a
    // is accepted.
    step = std::min(options.step, step * std::exp(0.3 * ((accepted ? 1 : 0) - options.acceptance)));
  }
}

/// All coolings on one allowance.
void anneal(const AnnealingOptions& options, const Allowance& allowance, Evaluator& evaluator, Random& random) {
  const bool had_start = evaluator.has_incumbent();
  const Incumbent given = evaluator.incumbent();
  const Survey surveyed = survey(allowance, evaluator, random);
  State start = had_start ? State{given.rotation, given.value} : surveyed.best;
  for (int cycle = 0; cycle < options.cycles && !allowance.spent(); ++cycle) {
    if (cycle > 0 && options.reheat == AnnealingOptions::Reheat::kBest)
      start = {evaluator.incumbent().rotation, evaluator.incumbent().value};
    else if (cycle > 0) start.rotation = random_rotation(random), start.value = evaluator.value(start.rotation);
    const auto left = static_cast<std::uint64_t>(options.cycles - cycle);
    cool(options, start, options.hot * surveyed.deviation, allowance.remaining() / left, evaluator, random);
  }
}

void AnnealingOptions::bind(Parameters& table) {
  Allowance::bind(table, evaluations);
  table
      .choice("cooling", cooling,
              {{"geometric", Cooling::kGeometric},
               {"linear", Cooling::kLinear},
               {"fast", Cooling::kFast},
               {"boltzmann", Cooling::kBoltzmann}},
              "how the temperature falls with the step number k: c^k, 1-ck, 1/k or 1/log(k)")
      .real("hot", hot, 1e-12, 1e6, "first temperature, in standard deviations of the objective")
      .real("cold", cold, 1e-15, 1e6, "last temperature, likewise")
      .integer("cycles", cycles, 1, 1000000, "number of coolings, which share the evaluations")
      .choice("reheat", reheat, {{"best", Reheat::kBest}, {"random", Reheat::kRandom}},
              "where coolings after the first begin: at the best rotation so far or a random one")
      .real("acceptance", acceptance, 0.01, 0.99, "the step length adapts so that this share of moves is accepted")
      .real("step", step, 1e-9, 3, "first and longest step: standard deviation (radians) of each component of a turn");
}

void AnnealingOptions::check() const {
  if (cold > hot) throw ParameterError("anneal: cold=" + std::to_string(cold) + " is above hot=" + std::to_string(hot));
}

void anneal_in_rounds(const AnnealingOptions& options, Evaluator& evaluator, const Domain&, Random& random) {
  const Allowance allowance(evaluator, options.evaluations);
  for (int round = 0; !allowance.spent(); ++round)
    anneal(options, Allowance(evaluator, allowance.plan(round)), evaluator, random);
}

}  // namespace

void add_anneal(Registry& registry) {
  registry.add(GlobalMethod<AnnealingOptions>{.name = "anneal",
                                              .help = "simulated annealing on rotations, with adaptive step length",
                                              .capabilities = {.uses_domain = false},
                                              .run = anneal_in_rounds});
}

}  // namespace rectilin
