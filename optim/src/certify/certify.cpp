#include "rectilin/optim/certify.h"

#include "certify/branch_and_bound.h"
#include "certify/optima.h"
#include "certify/polish.h"
#include "rectilin/optim/registry.h"

namespace rectilin {

void CertifyOptions::bind(Parameters& table) {
  table.real("gap", gap, 0, 10, "stop when the merit is known to within this")
      .integer("cells", cells, 0, 2'000'000'000, "stop after so many boxes of rotations; 0: no limit")
      .real("seconds", seconds, 0, 1e9, "stop after so much time; 0: no limit")
      .integer("batch", batch, 1, 100'000, "boxes a round, or more where many are open")
      .integer("bundle", bundle, 1, certification::Cell::kMaxBundle, "cuts kept on each axis of a box")
      .integer("descent", descent, 0, 1000, "steps of the local search from each better rotation")
      .flag("balls", balls, "certified balls round the incumbent")
      .flag("floors", floors, "bounds of h where the axes point to when there are many boxes")
      .flag("polish", polish, "solve for the frame at which faces are parallel to axes")
      .flag("optima", optima, "find all frames within the gap");
}

namespace {

Certificate certificate_of(const certification::ProofTree& proof, const CertifyResult& result, const CutBounds& facts) {
  Certificate certificate;
  certificate.tree = "f";
  // Whoever recomputes the leaves' bounds rounds differently, so the claim is a little less than what was proved.
  const double claim = std::min(result.lower, proof.bound()) - certification::rounding_allowance(facts);
  certificate.lower = facts.floor;
  if (claim > facts.floor) {
    certificate = proof.certificate();
    certificate.lower = claim;
  }
  certificate.rotation = result.incumbent.rotation;
  certificate.value = result.incumbent.value;
  return certificate;
}

}  // namespace

CertifyResult certify(Evaluator& evaluator, const CertifyOptions& options, Certificate* certificate) {
  if (!evaluator.objective().has_cuts())
    throw ParameterError("certify: '" + evaluator.objective().name() + "' has no cuts");
  std::optional<certification::ProofTree> proof;
  if (certificate) proof.emplace();
  CertifyResult result = certification::BranchAndBound(evaluator, options, proof ? &*proof : nullptr).run();
  if (options.polish && evaluator.has_incumbent() && evaluator.objective().generators().size() > 0) {
    certification::polish(evaluator);
    result.incumbent = evaluator.incumbent();
    result.lower = std::min(result.lower, result.incumbent.value);
  }
  if (proof) *certificate = certificate_of(*proof, result, evaluator.objective().cut_bounds());
  if (options.optima && result.closed) {
    const double threshold = certification::threshold_value(evaluator.objective(), result.incumbent.value, options.gap);
    result.optima = certification::find_optima(evaluator, options, threshold);
  }
  return result;
}

GlobalMethod<CertifyOptions> certify_method() {
  return {.name = "certify",
          .help = "branch and bound with a proof: the global minimum to within a gap",
          .capabilities =
              {.uses_domain = false, .uses_random = false, .batches = true, .needs_cuts = true, .certifies = true},
          .run = [](const CertifyOptions& options, Evaluator& evaluator, const Domain&, Random&) {
            certify(evaluator, options);
          }};
}

void add_certify(Registry& registry) { registry.add(certify_method()); }

}  // namespace rectilin
