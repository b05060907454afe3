// The house optim in Python: Problem, Evaluator, optimizers(), optimize(), and Python callables as optimizers.
#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "arrays.h"
#include "interrupt.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/optimizer.h"

namespace rectilin::python {

/// rectilin.Problem: the objective of a mesh.
struct Problem {
  std::shared_ptr<const ProjectedArea> objective;
  std::size_t faces = 0;
};

/// A Problem itself, or that of a mesh as GivenMesh takes it.
std::shared_ptr<Problem> problem_of(py::handle given, py::handle faces, const std::optional<std::string>& name);

/// The Python optimizers at work: which threads, and when each last asked for something. All members need the GIL.
class AtWork {
 public:
  using Clock = std::chrono::steady_clock;

  void begin(unsigned long thread) { last_[thread] = {Clock::now(), false}; }
  void asked(unsigned long thread) { last_[thread].when = Clock::now(); }
  /// Was it told to end because it was silent?
  bool end(unsigned long thread);

  /// Raises Exhausted in threads that have asked for nothing in so many seconds, and in all if `all`. What is stuck
  /// inside a function of C sees it only on its return.
  void end_silent(double seconds, bool all);

 private:
  struct State {
    Clock::time_point when;
    bool silent = false;
  };
  std::map<unsigned long, State> last_;
};

/// A Python callable `search(problem, budget, rng)` behind the interface of an optimizer. Its exceptions are errors of
/// the run, in one line; but KeyboardInterrupt and SystemExit stop it and are raised later by `interrupt`, and if
/// `raise_all` so are all others.
class CallableOptimizer final : public Optimizer {
 public:
  CallableOptimizer(py::function search, std::string name, std::shared_ptr<AtWork> at_work, Interrupt& interrupt,
                    bool raise_all);
  ~CallableOptimizer() override;

  std::string name() const override { return name_; }
  Json parameters() const override { return Json::object(); }
  Capabilities capabilities() const override { return {.deterministic = false, .batches = true}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;

 private:
  py::object search_;
  std::string name_;
  std::shared_ptr<AtWork> at_work_;
  Interrupt& interrupt_;
  bool raise_all_;
};

/// "python:" and the callable's own name, as a registry takes it.
std::string name_of_callable(py::handle search);

void bind_optim(py::module_& m);

}  // namespace rectilin::python
