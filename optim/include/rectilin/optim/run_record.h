// One run of one optimizer on one objective, and all there is to say of it afterwards.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/optim/evaluator.h"
#include "rectilin/optim/optimizer.h"

namespace rectilin {

struct RunRecord {
  enum class Outcome { kFinished, kBudget, kStopped, kFailed };

  std::string objective;
  std::string optimizer;
  Json parameters;
  std::string domain;
  std::uint64_t seed = 0;
  Outcome outcome = Outcome::kFinished;
  std::string error;                  ///< what a failed run said; its incumbent still stands
  Incumbent incumbent;                ///< as reduce_to_zone() turns it; value is infinite if nothing was evaluated
  std::optional<double> value_bound;  ///< proved: no rotation has a smaller value
  double merit = 0;                   ///< of the incumbent; NaN if there is none
  Costs costs;
  double seconds = 0;        ///< wall clock
  double cpu_seconds = 0;    ///< of the run's thread if it can use only one, else of the whole process
  int threads = 1;           ///< most that the run could use
  std::uint64_t digest = 0;  ///< Evaluator::digest()
  std::vector<TracePoint> trace;
};

struct RunSettings {
  Budget budget = {};
  std::uint64_t seed = 1;
  const Domain* domain = &covering_domain();
  std::stop_token stop = {};
  std::function<void(const Evaluator&)> on_progress = {};  ///< see Evaluator::watch()
};

/// Runs an optimizer. Never throws for what the optimizer throws: that is a failed run, and its record keeps
/// the best rotation found until then.
RunRecord run_optimizer(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings);

/// The same with a search in the place of optimizer.run(), for callers that want more of it than the record holds;
/// `optimizer` says what it is called and what it needs.
RunRecord run_search(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings,
                     const std::function<void(Evaluator& evaluator, Random& random)>& search);

std::string to_string(RunRecord::Outcome outcome);

/// The record as JSON, without the trace. Infinite and absent numbers are null; the rotation is three rows.
Json to_json(const RunRecord& record);

/// Three rows of three numbers.
Json to_json(const Rotation& rotation);

}  // namespace rectilin
