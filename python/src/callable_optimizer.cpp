#include <cctype>

#include "errors.h"
#include "evaluator.h"
#include "optim.h"

namespace rectilin::python {
namespace {

/// Takes the evaluator back however the search ends.
class Lease {
 public:
  Lease(AtWork& at_work, LentEvaluator& lent, unsigned long thread) : at_work_(at_work), lent_(lent), thread_(thread) {
    at_work_.begin(thread_);
  }
  ~Lease() { end(); }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  /// Was the search told to end because it was silent?
  bool end() {
    lent_.take_back();
    return at_work_.end(thread_);
  }

 private:
  AtWork& at_work_;
  LentEvaluator& lent_;
  unsigned long thread_;
};

constexpr const char* kSilent = "asked for nothing for too long (see `patience`)";

}  // namespace

bool AtWork::end(unsigned long thread) {
  const auto state = last_.extract(thread);
  if (!state) return false;
  PyThreadState_SetAsyncExc(thread, nullptr);  // it may have ended by itself meanwhile
  return state.mapped().silent;
}

void AtWork::end_silent(double seconds, bool all) {
  for (auto& [thread, state] : last_) {
    const bool silent = std::chrono::duration<double>(Clock::now() - state.when).count() > seconds;
    if (!silent && !all) continue;
    state.silent = state.silent || silent;
    PyThreadState_SetAsyncExc(thread, exhausted_type().ptr());
  }
}

CallableOptimizer::CallableOptimizer(py::function search, std::string name, std::shared_ptr<AtWork> at_work,
                                     Interrupt& interrupt, bool raise_all)
    : search_(std::move(search)),
      name_(std::move(name)),
      at_work_(std::move(at_work)),
      interrupt_(interrupt),
      raise_all_(raise_all) {}

CallableOptimizer::~CallableOptimizer() {
  const py::gil_scoped_acquire acquire;
  search_ = py::object();
}

void CallableOptimizer::run(Evaluator& evaluator, const Domain& domain, Random& random) const {
  const py::gil_scoped_acquire acquire;
  const unsigned long thread = PyThread_get_thread_ident();
  const auto lent = std::make_shared<LentEvaluator>(evaluator, domain, at_work_, thread);
  Lease lease(*at_work_, *lent, thread);
  try {
    const py::object rng = py::module_::import("numpy").attr("random").attr("default_rng")(random.seed());
    const py::object result = search_(lent, evaluator.remaining(), rng);
    if (!result.is_none())
      throw std::runtime_error("the optimizer returned a " +
                               std::string(py::str(py::type::of(result).attr("__name__"))) +
                               "; it should return nothing: the best rotation that it asked for is the result");
  } catch (py::error_already_set& error) {
    const bool silent = lease.end();
    if (error.matches(exhausted_type())) {
      if (silent) throw std::runtime_error(kSilent);
      return;
    }
    if (raise_all_ || !error.matches(PyExc_Exception)) {
      interrupt_.raise_later(std::current_exception());
      return;
    }
    throw std::runtime_error(one_line(error));
  }
}

std::string name_of_callable(py::handle search) {
  std::string name = "python:";
  const std::string own = py::hasattr(search, "__name__") ? py::str(search.attr("__name__"))
                                                          : py::str(py::type::of(search).attr("__name__"));
  for (const char c : own) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

}  // namespace rectilin::python
