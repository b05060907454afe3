// What holds for every optimizer of the registry, and what each promises of its own.
#include <tbb/global_control.h>

#include <set>

#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/run_record.h"
#include "support/catch.h"
#include "support/frame_objective.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

RunRecord run(const std::string& spec, std::uint64_t seed = 1, Budget budget = {},
              const Domain& domain = covering_domain()) {
  Random random(99);
  const test::CubeInPose cube(random_rotation(random));
  return run_optimizer(*all_optimizers().make(spec), cube, {.budget = budget, .seed = seed, .domain = &domain});
}

}  // namespace

TEST_CASE("every optimizer keeps the budget, finds something and repeats itself", "[optimizers]") {
  const Budget budget{.evaluations = 1234};
  for (const auto& entry : all_optimizers().entries()) {
    INFO(entry.name);
    const RunRecord a = test::run_on_pyramid(entry.name, 7, budget);
    tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const RunRecord b = test::run_on_pyramid(entry.name, 7, budget);
    REQUIRE(a.outcome != RunRecord::Outcome::kFailed);
    REQUIRE(a.costs.evaluations() <= 1234);
    REQUIRE(a.merit > 0);
    REQUIRE(a.merit <= test::kPyramid + 1e-12);
    REQUIRE(a.digest == b.digest);
    REQUIRE(a.costs.evaluations() == b.costs.evaluations());
    REQUIRE(a.incumbent.rotation.matrix() == b.incumbent.rotation.matrix());
  }
}

TEST_CASE("the seed matters to those that say so, and to no others", "[optimizers]") {
  for (const auto& entry : all_optimizers().entries()) {
    INFO(entry.name);
    std::set<std::uint64_t> digests;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      digests.insert(test::run_on_pyramid(entry.name, seed, {.evaluations = 5000}).digest);
    REQUIRE((digests.size() > 1) == all_optimizers().make(entry.name)->capabilities().uses_random);
  }
}

TEST_CASE("every optimizer needs what it says, and says so before it begins", "[optimizers]") {
  std::vector<std::string> specs = {"nlopt:G_MLSL?local=LD_LBFGS", "multistart?local=axis-sweep?starts=1",
                                    "random?evaluations=100+ceres"};
  for (const auto& entry : all_optimizers().entries()) specs.push_back(entry.name);
  for (const std::string& spec : specs) {
    INFO(spec);
    const auto optimizer = all_optimizers().make(spec);
    const Capabilities can = optimizer->capabilities();
    const Costs costs = run_optimizer(*optimizer, test::pyramid(), {.budget = {.evaluations = 2000}}).costs;
    REQUIRE((costs.cuts > 0) == can.needs_cuts);
    REQUIRE((costs.smooths > 0) == can.needs_smooth);
    REQUIRE((costs.turns > 0) == can.needs_turns);

    const RunRecord without = run_optimizer(*optimizer, test::CubeInPose(), {.budget = {.evaluations = 100}});
    REQUIRE((without.outcome == RunRecord::Outcome::kFailed) == (can.needs_smooth || can.needs_turns));
    if (without.outcome == RunRecord::Outcome::kFailed) REQUIRE(without.costs.evaluations() == 0);
  }
}

TEST_CASE("capabilities of a whole are those of all its parts, or of any", "[optimizers]") {
  const Capabilities whole =
      together({.deterministic = true, .needs_smooth = true, .local = true},
               {.deterministic = false, .uses_domain = false, .needs_turns = true, .local = true});
  REQUIRE_FALSE(whole.deterministic);
  REQUIRE(whole.local);
  REQUIRE((whole.needs_smooth && whole.needs_turns && whole.uses_domain));
  REQUIRE_FALSE(whole.needs_cuts);
  REQUIRE(to_json(whole)["needs_smooth"] == true);
}

TEST_CASE("every optimizer ends, however small the budget, and without one", "[optimizers]") {
  for (const auto& entry : all_optimizers().entries()) {
    INFO(entry.name);
    for (std::uint64_t few : {0, 1, 2, 3, 4, 5, 9, 21, 50}) {
      const RunRecord record = test::run_on_pyramid(entry.name, 1, {.evaluations = few});
      REQUIRE(record.outcome != RunRecord::Outcome::kFailed);
      REQUIRE(record.costs.evaluations() <= few);
      // The first that is asked for is the objective itself, so that a run cut off at any time has found something.
      const Capabilities can = all_optimizers().make(entry.name)->capabilities();
      if (few > 0 && !can.needs_cuts && !can.needs_turns) REQUIRE(std::isfinite(record.incumbent.value));
    }
    REQUIRE(test::run_on_pyramid(entry.name).costs.evaluations() <= 30000);
    REQUIRE(test::run_on_pyramid(entry.name, 1, {.seconds = 0}).costs.evaluations() == 0);
  }
}

TEST_CASE("every local optimizer starts at the incumbent, on any domain", "[optimizers]") {
  const Rotation minimum = test::run_on_pyramid("nelder-mead").incumbent.rotation;
  const Rotation start = rotation_from_vector({0.01, -0.02, 0.01}) * minimum;
  for (const auto& entry : all_optimizers().entries()) {
    const auto optimizer = all_optimizers().make(entry.name);
    if (!optimizer->capabilities().local) continue;
    for (const Domain* domain : {&covering_domain(), &zone_domain()}) {
      INFO(entry.name << " on " << domain->name());
      Evaluator evaluator(test::pyramid());
      const double before = evaluator.value(start);
      Random random(1);
      optimizer->run(evaluator, *domain, random);
      REQUIRE(evaluator.incumbent().value < before);
      REQUIRE(frame_angle(evaluator.incumbent().rotation, start) < 0.2);
    }
  }
}

TEST_CASE("an optimizer made from its own parameters is the same", "[optimizers]") {
  for (const auto& entry : all_optimizers().entries()) {
    const auto optimizer = all_optimizers().make(entry.name);
    const Json parameters = optimizer->parameters();
    REQUIRE(all_optimizers().make(entry.name, parameters)->parameters() == parameters);
    REQUIRE(parameters.size() == entry.parameters.size());
    REQUIRE(optimizer->name() == entry.name);
  }
}

TEST_CASE("the registry names what it does not know", "[optimizers]") {
  REQUIRE_THROWS_WITH(all_optimizers().make("gaa"), Catch::StartsWith("no optimizer 'gaa'; did you mean 'ga'? There are ga, "));
  REQUIRE_THROWS_AS(all_optimizers().make("ga?population=1"), ParameterError);
  REQUIRE_THROWS_AS(all_optimizers().make("ga?population=10&elitism=10"), ParameterError);
}

TEST_CASE("ga spends population times generations, as the paper's 10,000", "[optimizers][ga]") {
  const RunRecord record = run("ga");
  REQUIRE(record.costs.values == 10000);
  REQUIRE(record.outcome == RunRecord::Outcome::kFinished);
  REQUIRE(run("ga?population=7&generations=3").costs.values == 21);
  REQUIRE(run("ga?generations=0", 1, {.evaluations = 333}).costs.values == 333);
}

TEST_CASE("ga comes near the cube's pose with each selection and code", "[optimizers][ga]") {
  for (const char* spec :
       {"ga", "ga?encoding=gray", "ga?selection=rank", "ga?points=2", "ga?elitism=0", "ga?selection=roulette"}) {
    INFO(spec);
    double best = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) best = std::max(best, run(spec, seed).merit);
    REQUIRE(best > 0.97);  // the mean over all rotations is 0
  }
}

TEST_CASE("grid contains the ends of the box, so an aligned cube is met exactly", "[optimizers][grid]") {
  const test::CubeInPose aligned;
  const auto grid = all_optimizers().make("grid?points=3&levels=0");
  const RunRecord record = run_optimizer(*grid, aligned, {.domain = &paper_domain()});
  REQUIRE(record.costs.values == 27);
  REQUIRE(record.incumbent.value == Approx(1).epsilon(1e-15));
}

TEST_CASE("grid refines: each level comes nearer", "[optimizers][grid]") {
  double previous = 0;
  for (int levels : {0, 3, 6, 12}) {
    const RunRecord record = run("grid?points=10&levels=" + std::to_string(levels), 1, {}, zone_domain());
    REQUIRE(record.costs.values == 1000u + levels * 8u * 125u);
    REQUIRE(record.merit >= previous);
    previous = record.merit;
  }
  REQUIRE(previous > 0.9999);
}

TEST_CASE("a run that throws keeps what it had found", "[optimizers]") {
  class Thrower final : public Optimizer {
    std::string name() const override { return "thrower"; }
    Json parameters() const override { return Json::object(); }
    Capabilities capabilities() const override { return {}; }
    void run(Evaluator& evaluator, const Domain&, Random&) const override {
      evaluator.value(Rotation());
      throw std::runtime_error("foreign trouble");
    }
  };
  const RunRecord record = run_optimizer(Thrower(), test::CubeInPose(), {});
  REQUIRE(record.outcome == RunRecord::Outcome::kFailed);
  REQUIRE(record.error == "foreign trouble");
  REQUIRE(record.incumbent.value == 1);
  REQUIRE(to_json(record)["outcome"] == "failed");
}
