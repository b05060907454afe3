#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

TEST_CASE("each stage starts where the one before stopped", "[pipeline]") {
  const RunRecord first = test::run_on_pyramid("super-fibonacci?count=500");
  const RunRecord both = test::run_on_pyramid("super-fibonacci?count=500+nlopt:LN_SBPLX");
  REQUIRE(both.optimizer == "super-fibonacci+nlopt:LN_SBPLX");
  REQUIRE(both.costs.values > 500);
  REQUIRE(both.merit > first.merit);
  // All that the first stage found is in the trace of both.
  for (std::size_t i = 0; i < first.trace.size(); ++i) REQUIRE(both.trace[i].value == first.trace[i].value);
}

TEST_CASE("a stage that spends all leaves nothing", "[pipeline]") {
  const RunRecord record = test::run_on_pyramid("random+axis-sweep", 1, {.evaluations = 300});
  REQUIRE(record.costs.values == 300);
  REQUIRE(record.costs.turns == 0);
}

TEST_CASE("a pipeline is made again from its name and parameters", "[pipeline]") {
  const auto one =
      all_optimizers().make("ga?mutation=1e-2&generations=5+anneal?cold=1e-8&evaluations=1e+3+nelder-mead");
  REQUIRE(one->name() == "ga+anneal+nelder-mead");
  REQUIRE(one->parameters().size() == 3);
  REQUIRE(one->parameters()[1]["evaluations"] == 1000);  // the plus of 1e+3 is the number's
  const auto again = all_optimizers().make(one->name(), one->parameters());
  REQUIRE(again->parameters() == one->parameters());
  REQUIRE_THROWS_AS(all_optimizers().make("ga+nelder-mead", Json::object()), ParameterError);
}

TEST_CASE("a pipeline is as capable as its stages", "[pipeline]") {
  const auto can = [](const char* spec) { return all_optimizers().make(spec)->capabilities(); };
  REQUIRE_FALSE(can("ga+nelder-mead").local);
  REQUIRE(can("nelder-mead+nlopt:LN_SBPLX").local);
  REQUIRE(can("super-fibonacci+nlopt:GN_DIRECT").uses_domain);
  REQUIRE_FALSE(can("super-fibonacci+nelder-mead").uses_domain);
  REQUIRE_FALSE(can("grid+super-fibonacci").uses_random);
}

TEST_CASE("a wrong stage is named", "[pipeline]") {
  REQUIRE_THROWS_WITH(all_optimizers().make("ga+nonsense"), Catch::StartsWith("no optimizer 'nonsense'"));
  REQUIRE_THROWS_WITH(all_optimizers().make("ga+"), Catch::StartsWith("no optimizer 'ga+'"));
  REQUIRE_THROWS_WITH(all_optimizers().make("+ga"), Catch::Contains("has no name"));
}
