#include "rectilin/evaluation/tuning.h"

#include <algorithm>
#include <set>

#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/provenance.h"
#include "writing.h"

namespace rectilin::evaluation {
namespace {

std::vector<std::string> terms_of(const TuningPlan& plan) {
  std::vector<std::string> specs;
  std::set<std::string> seen;
  for (const retrieval::Term& term : retrieval::parse_composite(plan.composite)) {
    if (!seen.insert(term.spec).second) throw ParameterError("--tune: '" + term.spec + "' is there twice");
    specs.push_back(term.spec);
  }
  if (specs.size() < 2) throw ParameterError("--tune: one descriptor alone has no weights to tune");
  return specs;
}

std::string sum_of(const std::vector<std::string>& specs, const std::vector<double>& weights) {
  std::string text;
  char number[32];
  for (std::size_t i = 0; i < specs.size(); ++i) {
    std::snprintf(number, sizeof number, "%.3g", weights[i]);
    text += (i > 0 ? "+" : "") + std::string(number) + "*" + specs[i];
  }
  return text;
}

}  // namespace

void add_terms(std::vector<Contestant>& contestants, const TuningPlan& plan) {
  for (const std::string& spec : terms_of(plan)) {
    const bool there = std::ranges::any_of(
        contestants, [&](const Contestant& c) { return c.kind == Contestant::Kind::kDescriptor && c.text == spec; });
    if (there) continue;
    for (const Contestant& c : contestants)
      if (c.label == spec) throw ParameterError("--tune: '" + spec + "' is the label of something else");
    contestants.push_back({spec, spec});
  }
}

TuningOutcome tune_composite(const TuningPlan& plan, const Evaluation& evaluation, const std::filesystem::path& out,
                             const EvaluationSettings& settings) {
  const std::vector<std::string> specs = terms_of(plan);
  std::vector<retrieval::DistanceMatrix> scaled;  // as a composite scales its terms
  for (const std::string& spec : specs)
    for (const Result& result : evaluation.results)
      if (result.contestant.kind == Contestant::Kind::kDescriptor && result.contestant.text == spec) {
        scaled.push_back(result.matrix);
        const double typical = retrieval::make_descriptor(spec)->typical_distance();
        for (float& distance : scaled.back().values()) distance = static_cast<float>(distance / typical);
        break;
      }
  std::vector<const retrieval::DistanceMatrix*> matrices;
  for (const retrieval::DistanceMatrix& matrix : scaled) matrices.push_back(&matrix);
  const std::vector<bool> all(evaluation.classes.models.size(), true);
  const WeightedScore score(matrices, evaluation.classes, all, all);
  TuningOutcome outcome;
  Json record = Json::array();
  Tuned chosen;
  double chosen_unseen = -1;
  std::size_t done = 0;
  for (const std::string& tuner : tuners()) {
    if (settings.on_progress)
      settings.on_progress(done++, tuners().size(), std::numeric_limits<double>::infinity(), "weights by " + tuner);
    const Tuned tuned = tune(
        tuner, [&](const auto& w) { return score(w); }, specs.size(), plan.budget, plan.seed, settings.stop);
    const CrossValidation validation =
        cross_validate(tuner, matrices, evaluation.classes, plan.folds, plan.budget, plan.seed, settings.stop);
    if (settings.stop.stop_requested()) return outcome;
    Json folds = Json::array();
    for (const Tuned& fold : validation.folds) folds.push_back({{"weights", fold.weights}, {"dcg", fold.score}});
    record.push_back({{"tuner", tuner},
                      {"weights", tuned.weights},
                      {"dcg", tuned.score},
                      {"evaluations", tuned.evaluations},
                      {"dcg_unseen_classes", validation.unseen},
                      {"dcg_equal_weights", validation.equal},
                      {"folds", folds}});
    outcome.lines.push_back(tuner + ": DCG " + percent(tuned.score) + ", on classes not tuned for " +
                            percent(validation.unseen) + ", with equal weights " + percent(validation.equal) + ": " +
                            sum_of(specs, tuned.weights));
    if (validation.unseen > chosen_unseen) {
      chosen_unseen = validation.unseen;
      chosen = tuned;
    }
  }
  const Json origin = {{"tuning", record},
                       {"terms", specs},
                       {"budget", plan.budget},
                       {"folds", plan.folds},
                       {"seed", plan.seed},
                       {"models", evaluation.classes.models.size()},
                       {"provenance", laboratory::provenance(settings.command_line)}};
  write_whole_file(out / "tuning.json", to_text(origin, 1) + '\n');
  write_weights(out / "weights.json", specs, chosen.weights,
                {{"dcg", chosen.score}, {"dcg_unseen_classes", chosen_unseen}});
  outcome.lines.push_back("weights: " + (out / "weights.json").string());
  outcome.complete = true;
  return outcome;
}

}  // namespace rectilin::evaluation
