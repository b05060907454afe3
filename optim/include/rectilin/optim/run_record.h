// One run of one optimizer on one objective, and the record of it.
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
  std::string error;    ///< message of a failed run, whose incumbent is valid all the same
  Incumbent incumbent;  ///< as reduce_to_zone() returns it; the value is infinite if nothing was evaluated
  std::optional<double> value_bound;  ///< proved: no rotation has a smaller value
  double merit = 0;                   ///< merit of the incumbent; NaN if there is none
  Costs costs;
  double seconds = 0;        ///< wall clock
  double cpu_seconds = 0;    ///< of the run's thread if it may use only one, otherwise of the whole process
  int threads = 1;           ///< number of threads that the run could use
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

/// Runs an optimizer. If the optimizer throws, this does not: it returns the record of a failed run, with the best
/// rotation found until then.
RunRecord run_optimizer(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings);

/// Likewise, but calls `search` instead of optimizer.run(), for callers that want more from a search than the record
/// holds. `optimizer` tells what it is called and what it needs.
RunRecord run_search(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings,
                     const std::function<void(Evaluator& evaluator, Random& random)>& search);

std::string to_string(RunRecord::Outcome outcome);

/// The record as JSON, without the trace. Infinite and missing numbers become null; the rotation is three rows.
Json to_json(const RunRecord& record);

/// Three rows of three numbers.
Json to_json(const Rotation& rotation);

}  // namespace rectilin
