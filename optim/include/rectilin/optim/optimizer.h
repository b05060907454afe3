// An optimizer: a search for the rotation of least value.
#pragma once

#include <memory>
#include <string>

#include "rectilin/base/parameters.h"
#include "rectilin/base/random.h"
#include "rectilin/optim/domain.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// What an optimizer is like and what it asks of an objective.
struct Capabilities {
  bool deterministic = true;  ///< same seed and budget in evaluations, same trace, for any number of threads
  bool uses_domain = true;    ///< searches the domain's box; otherwise it works on rotations themselves
  bool uses_random = true;    ///< the seed matters
  bool batches = false;       ///< asks for many values at a time
  bool needs_cuts = false;    ///< asks for cuts
  bool needs_smooth = false;  ///< asks for the smooth surrogate
  bool needs_turns = false;   ///< asks for best turns
  bool certifies = false;     ///< reports lower bounds
  bool local = false;         ///< improves a start (the incumbent, if there is one) rather than searching everywhere
};

/// Every capability with its name, in the order of declaration: `{"deterministic": true, ...}`.
Json to_json(const Capabilities& capabilities);

/// What the whole can do and needs if it runs all its parts: deterministic and local if all are, else what any is.
Capabilities together(const Capabilities& a, const Capabilities& b);

/// Immutable and thread safe: one optimizer may serve many runs at once.
class Optimizer {
 public:
  virtual ~Optimizer() = default;

  /// The name it is made by, without parameters.
  virtual std::string name() const = 0;
  /// Every parameter with its value; making one from these gives the same optimizer.
  virtual Json parameters() const = 0;
  virtual Capabilities capabilities() const = 0;

  /// Searches until its own end or until evaluator.exhausted(). The result is the evaluator's incumbent.
  /// If the evaluator has an incumbent already, a local optimizer starts there and a global one may use it.
  virtual void run(Evaluator& evaluator, const Domain& domain, Random& random) const = 0;
};

/// Throws ParameterError if `objective` does not offer what `optimizer` needs. run_optimizer() asks before it begins.
void require_needs(const Optimizer& optimizer, const Objective& objective);

/// Base of an optimizer whose settings are a struct with `bind(Parameters&)`; see method.h, which needs no class.
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
