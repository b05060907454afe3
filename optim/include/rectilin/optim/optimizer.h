// An optimizer: a search for the rotation with the least value.
#pragma once

#include <memory>
#include <string>

#include "rectilin/base/parameters.h"
#include "rectilin/base/random.h"
#include "rectilin/optim/domain.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// Properties of an optimizer, and what it needs from an objective.
struct Capabilities {
  bool deterministic =
      true;                 ///< the same seed and budget in evaluations give the same trace, for any number of threads
  bool uses_domain = true;  ///< searches the box of a domain; otherwise it works on rotations directly
  bool uses_random = true;  ///< the result depends on the seed
  bool batches = false;     ///< asks for many values in one call
  bool needs_cuts = false;  ///< needs cuts
  bool needs_smooth = false;  ///< needs the smooth surrogate
  bool needs_turns = false;   ///< needs best turns
  bool certifies = false;     ///< proves lower bounds
  bool local = false;         ///< improves a start (the incumbent, if there is one) instead of searching everywhere
};

/// Every capability with its name, in the order of declaration: `{"deterministic": true, ...}`.
Json to_json(const Capabilities& capabilities);

/// The capabilities of a combination that runs both parts: deterministic and local only if both are, everything else if
/// either is.
Capabilities together(const Capabilities& a, const Capabilities& b);

/// Immutable and thread safe: one optimizer may serve many runs at once.
class Optimizer {
 public:
  virtual ~Optimizer() = default;

  /// The name by which the registry knows it, without parameters.
  virtual std::string name() const = 0;
  /// All parameters with their values; an optimizer made from these is the same.
  virtual Json parameters() const = 0;
  virtual Capabilities capabilities() const = 0;

  /// Searches until the method ends by itself or evaluator.exhausted(). The result is the evaluator's incumbent. If
  /// there is an incumbent already, a local optimizer starts from it and a global one may use it.
  virtual void run(Evaluator& evaluator, const Domain& domain, Random& random) const = 0;
};

/// Throws ParameterError if `objective` does not offer what `optimizer` needs. run_optimizer() checks this first.
void require_needs(const Optimizer& optimizer, const Objective& objective);

/// Base class of optimizers whose settings are a struct with `bind(Parameters&)`. method.h makes such optimizers
/// without a class.
template <class Options>
class OptimizerWith : public Optimizer {
 public:
  explicit OptimizerWith(Options options) : options_(std::move(options)) {}

  Json parameters() const final {
    Options copy = options_;
    Parameters table;
    copy.bind(table);
    return table.values();
  }

  const Options& options() const { return options_; }

 protected:
  Options options_;
};

}  // namespace rectilin
