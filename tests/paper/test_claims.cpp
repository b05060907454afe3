// The ledger of claims, and the runner.
#include <tbb/global_control.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "claims/tests.h"
#include "rectilin/paper/claims.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::paper;

namespace {

const std::filesystem::path kRoot = RECTILIN_ROOT;

Validation run(const std::vector<std::string>& sources, const std::vector<std::string>& claims) {
  ValidationSettings settings;
  settings.claims = claims;
  return validate(sources, settings);
}

}  // namespace

TEST_CASE("every claim has a test, a file with it, and a name of its own", "[claims]") {
  std::set<std::string> ids;
  for (const Claim& claim : all_claims()) {
    INFO(claim.id);
    REQUIRE(ids.insert(claim.id).second);
    REQUIRE(std::filesystem::exists(kRoot / claim.code));
    REQUIRE(claim.tolerance >= 0);
    REQUIRE_FALSE(claim.why.empty());
    REQUIRE((claim.should_hold || !claim.remark.empty()));
  }
  REQUIRE(claims::claim_tests().size() == ids.size());
  for (const auto& test : claims::claim_tests()) {
    INFO(test.claim);
    REQUIRE(ids.contains(std::string(test.claim)));
    REQUIRE((test.on_mesh || test.on_shapes || test.on_collection));
    REQUIRE((test.on_collection != nullptr) == (test.rows != nullptr));
  }
}

TEST_CASE("papers/claims.md holds the ledger's table", "[claims]") {
  std::ifstream in(kRoot / "papers/claims.md");
  std::ostringstream text;
  text << in.rdbuf();
  // If this fails, replace the table there by what `rectilin validate --markdown` prints.
  REQUIRE(text.str().find(claims_markdown()) != std::string::npos);
}

TEST_CASE("claims are judged as the ledger expects", "[claims]") {
  const Validation validation =
      run({}, {"definition", "theorem-1-if", "theorem-2-1", "eq-28-cubes", "near-rectilinear"});
  REQUIRE(validation.complete);
  REQUIRE(validation.errors.empty());
  REQUIRE(validation.as_expected());
  REQUIRE(validation.results.size() == 5);
  for (const ClaimResult& result : validation.results) {
    INFO(result.claim->id);
    REQUIRE((result.verdict == ClaimVerdict::kFails) == !result.claim->should_hold);
    REQUIRE(result.tested > 0);
  }
}

TEST_CASE("a mesh that cannot be read costs a line", "[claims]") {
  const Validation validation = run({"missing.off", "shape:pyramid", "shape:nonsense"}, {"eq-12", "linear-cost"});
  REQUIRE(validation.errors.size() == 2);
  REQUIRE(validation.errors[0].find("missing.off") != std::string::npos);
  REQUIRE(validation.results[0].tested == 1);
  REQUIRE(validation.results[0].verdict == ClaimVerdict::kHoldsWithMargin);
}

TEST_CASE("unknown claims are refused", "[claims]") { REQUIRE_THROWS_AS(run({}, {"fermat"}), ParameterError); }

TEST_CASE("verdicts and margins do not depend on threads or on other claims", "[claims]") {
  const std::vector<std::string> sources{"shape:pyramid", "shape:blob?faces=500", "shape:torus?slices=9"};
  const Validation all = run(sources, {"theorem-3-4", "eq-28-turned", "stable-150"});
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const Validation alone = run(sources, {"eq-28-turned"});
  REQUIRE(alone.results[0].decisive.margin == all.results[1].decisive.margin);
  REQUIRE(alone.results[0].decisive.where == all.results[1].decisive.where);
}

TEST_CASE("a stop leaves claims untested, not failed", "[claims]") {
  std::stop_source source;
  source.request_stop();
  ValidationSettings settings;
  settings.stop = source.get_token();
  const Validation validation = validate({}, settings);
  REQUIRE_FALSE(validation.complete);
  for (const ClaimResult& result : validation.results) REQUIRE(result.verdict == ClaimVerdict::kUntested);
}
