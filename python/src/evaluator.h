// rectilin.Evaluator: what a Python optimizer asks through.
#pragma once

#include <memory>
#include <thread>

#include "optim.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin::python {

/// Lends an Evaluator of C++ to one thread for the length of one run; whoever keeps it longer, or asks from another
/// thread, gets an exception. Every call needs the GIL, which so protects the state here.
class LentEvaluator {
 public:
  LentEvaluator(Evaluator& evaluator, const Domain& domain, std::shared_ptr<AtWork> at_work, unsigned long thread)
      : evaluator_(&evaluator), domain_(domain), at_work_(std::move(at_work)), thread_(thread) {}

  /// The run is over.
  void take_back() { evaluator_ = nullptr; }

  /// Throws RuntimeError if the run is over or this is another thread.
  Evaluator& get() const;
  /// The same to ask for something: raises Exhausted if nothing is left.
  Evaluator& ask() const;

  const Domain& domain() const { return domain_; }

 private:
  Evaluator* evaluator_;
  const Domain& domain_;
  std::shared_ptr<AtWork> at_work_;
  unsigned long thread_;
  mutable int refused_ = 0;  ///< times that something was asked for and nothing was left
};

void bind_evaluator(py::module_& m);

}  // namespace rectilin::python
