// NLopt as an optimizer of this project.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graduated.h"
#include "nlopt_algorithms.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/allowance.h"
#include "rectilin/optim/local.h"

namespace rectilin {
namespace {

/// Global searches get a single round, since they cannot continue from where another round ended.
constexpr Graduation kOneRound{.width = 1e-3, .narrow = 1e-3, .rounds = 1};

struct NloptOptions {
  const NloptAlgorithm* algorithm;
  int evaluations = 0;
  double tolerance = 1e-9;
  double step = 0.1;
  int population = 0;
  const NloptAlgorithm* sublocal = &kNloptAlgorithms[4];  // LN_NELDERMEAD
  Graduation graduation;

  bool gradient() const { return algorithm->gradient() || (algorithm->sublocal && sublocal->gradient()); }

  void bind(Parameters& table) {
    Allowance::bind(table, evaluations);
    table.real("tolerance", tolerance, 0, 1, "change of the coordinates that ends a search, radians or the like");
    if (!algorithm->gradient())
      table.real("step", step, 1e-9, 0.5, "first step of a local search, as a fraction of the box");
    if (algorithm->population)
      table.integer("population", population, 0, 1000000, "points in a generation; 0: the library decides");
    if (algorithm->sublocal) bind_sublocal(table);
    if (algorithm->gradient() && algorithm->local()) graduation.bind(table);
    else if (gradient() || algorithm->sublocal)
      table.real("width", graduation.narrow, 1e-12, 10, "width of the smooth surrogate, if it is used; radians");
  }

  void bind_sublocal(Parameters& table) {
    table.custom(
        "local", "an algorithm LN_... or LD_... of this family, such as LN_NELDERMEAD",
        [this](const Json& value) {
          const auto named =
              std::ranges::find_if(kNloptAlgorithms, [&](const auto& a) { return a.local() && value == a.name; });
          if (named == std::end(kNloptAlgorithms)) return false;
          sublocal = &*named;
          return true;
        },
        [this] { return Json(sublocal->name); }, "the local algorithm inside");
  }
};

/// The objective as NLopt sees it: a function of three numbers. Some algorithms go on asking after the allowance is
/// spent; they are answered without an evaluation.
class Task {
 public:
  Task(Evaluator& evaluator, const Domain& domain, const Allowance& allowance)
      : evaluator_(evaluator), domain_(domain), allowance_(allowance) {}

  void watch(nlopt::opt& opt) {
    opt_ = &opt;
    opt.set_min_objective(&Task::call, this);
  }

  /// From now on answers with the smooth surrogate of this width, and with its gradients.
  void smooth(double width) {
    width_ = width;
    least_ = std::numeric_limits<double>::infinity();
  }

  /// Evaluates the objective where the surrogate was least; returns that point, if there is one.
  std::optional<Eigen::Vector3d> settle() {
    if (least_ == std::numeric_limits<double>::infinity()) return std::nullopt;
    evaluator_.value(domain_.rotation(best_));
    return best_;
  }

 private:
  static double call(unsigned, const double* x, double* gradient, void* self) {
    return static_cast<Task*>(self)->at(Eigen::Vector3d(x), gradient);
  }

  double at(const Eigen::Vector3d& x, double* gradient) {
    if (gradient) std::fill_n(gradient, 3, 0.0);
    // One evaluation is kept for settle().
    if (allowance_.spent(width_ ? Costs::kPerSmooth + Costs::kPerValue : Costs::kPerValue)) {
      opt_->force_stop();
      return kBeyond;
    }
    if (!x.allFinite()) return kBeyond;  // PRAXIS may ask for such a point
    return width_ ? smooth_at(x, gradient) : evaluator_.value(domain_.rotation(x));
  }

  double smooth_at(const Eigen::Vector3d& x, double* gradient) {
    const SmoothValue smooth = evaluator_.smooth(domain_.rotation(x), *width_);
    if (smooth.value < least_) least_ = smooth.value, best_ = x;
    for (int i = 0; gradient && i < 3; ++i) {
      // Central differences of the map from the domain to rotations, not of the objective: they cost no evaluations and
      // err by h^2 only.
      constexpr double h = 1e-5;
      const Eigen::Vector3d d = h * Eigen::Vector3d::Unit(i);
      const Eigen::Matrix3d slope = (domain_.rotation(x + d).matrix() - domain_.rotation(x - d).matrix()) / (2 * h);
      gradient[i] = smooth.gradient.cwiseProduct(slope).sum();
    }
    return smooth.value;
  }

  static constexpr double kBeyond = 1e6;

  Evaluator& evaluator_;
  const Domain& domain_;
  const Allowance& allowance_;
  nlopt::opt* opt_ = nullptr;
  std::optional<double> width_;
  double least_ = std::numeric_limits<double>::infinity();
  Eigen::Vector3d best_ = Eigen::Vector3d::Zero();
};

std::vector<double> list(const Eigen::Vector3d& x) { return {x.begin(), x.end()}; }

class NloptSearch : public OptimizerWith<NloptOptions> {
 public:
  using OptimizerWith::OptimizerWith;

  std::string name() const override { return "nlopt:" + std::string(options_.algorithm->name); }

  Capabilities capabilities() const override {
    return {.uses_random = options_.algorithm->uses_start,
            .needs_smooth = options_.gradient(),
            .local = options_.algorithm->local()};
  }

  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override {
    const Rotation start =
        options_.algorithm->uses_start ? start_of(evaluator, random) : domain.from_unit(Eigen::Vector3d::Constant(0.5));
    search_from(start, evaluator, domain, random);
  }

 protected:
  void search_from(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const {
    nlopt::srand(static_cast<unsigned long>(random.bits()));
    const Allowance allowance(evaluator, options_.evaluations);
    Task task(evaluator, domain, allowance);
    Eigen::Vector3d x = domain.coordinates(start);
    if (!options_.gradient()) return minimise(task, allowance.remaining(), x, domain, evaluator);

    // Evaluate the true objective once, so that an interrupted run still has an incumbent.
    if (!evaluator.has_incumbent()) evaluator.value(domain.rotation(x));
    if (options_.algorithm->local()) descend(task, allowance, x, domain, evaluator);
    else search_surrogate(task, allowance, x, domain, evaluator);
  }

 private:
  void descend(Task& task, const Allowance& allowance, Eigen::Vector3d x, const Domain& domain,
               const Evaluator& evaluator) const {
    const Graduation& widths = options_.graduation;
    for (int round = 0; round < widths.rounds; ++round) {
      task.smooth(widths.at(round));
      minimise(task, allowance.remaining() / Costs::kPerSmooth, x, domain, evaluator);
      x = task.settle().value_or(x);
    }
  }

  /// The objective is evaluated only when a search of the surrogate has ended, so a search must end before the time
  /// is over.
  void search_surrogate(Task& task, const Allowance& allowance, const Eigen::Vector3d& start, const Domain& domain,
                        const Evaluator& evaluator) const {
    int round = 0;
    do {
      task.smooth(options_.graduation.narrow);
      minimise(task, allowance.plan(round++) / Costs::kPerSmooth, start, domain, evaluator);
      task.settle();
    } while (allowance.timed() && !allowance.spent());
  }

  void minimise(Task& task, std::uint64_t calls, const Eigen::Vector3d& start, const Domain& domain,
                const Evaluator& evaluator) const {
    if (calls == 0 || evaluator.exhausted()) return;
    // An nlopt::opt must not be copied once it has its objective: the copy would pass evaluations on to the original.
    nlopt::opt opt(options_.algorithm->id, 3);
    set_limits(opt, calls, evaluator);
    opt.set_lower_bounds(list(domain.lower()));
    opt.set_upper_bounds(list(domain.upper()));
    const std::vector<double> step = list(options_.step * (domain.upper() - domain.lower()));
    if (!options_.gradient()) opt.set_initial_step(step);
    if (options_.population > 0) opt.set_population(static_cast<unsigned>(options_.population));
    if (options_.algorithm->sublocal) {
      nlopt::opt inner(options_.sublocal->id, 3);
      set_limits(inner, calls, evaluator);
      if (!options_.gradient()) inner.set_initial_step(step);
      opt.set_local_optimizer(inner);
    }
    task.watch(opt);
    std::vector<double> x = list(start.cwiseMax(domain.lower()).cwiseMin(domain.upper()));
    double value;
    try {
      opt.optimize(x, value);
    } catch (const std::runtime_error&) {
      // Several algorithms end with such an exception, because of rounding or of force_stop(); the evaluator holds what
      // they found.
    }
  }

  /// Some algorithms ignore force_stop(), so the limits are set as well.
  void set_limits(nlopt::opt& opt, std::uint64_t calls, const Evaluator& evaluator) const {
    opt.set_xtol_abs(options_.tolerance);
    if (evaluator.budget().limits_seconds()) opt.set_maxtime(std::max(1e-9, evaluator.seconds_left()));
    opt.set_maxeval(static_cast<int>(std::min<std::uint64_t>(calls, std::numeric_limits<int>::max())));
  }
};

class NloptLocal final : public NloptSearch, public LocalSearch {
 public:
  using NloptSearch::NloptSearch;

  void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const override {
    search_from(start, evaluator, domain, random);
  }
};

std::unique_ptr<Optimizer> make_nlopt(NloptOptions options, const Registry&) {
  if (options.algorithm->local()) return std::make_unique<NloptLocal>(std::move(options));
  return std::make_unique<NloptSearch>(std::move(options));
}

}  // namespace

void add_nlopt(Registry& registry) {
  for (const NloptAlgorithm& algorithm : kNloptAlgorithms)
    registry.add("nlopt:" + std::string(algorithm.name), algorithm.help,
                 NloptOptions{.algorithm = &algorithm, .graduation = algorithm.local() ? Graduation() : kOneRound},
                 make_nlopt);
}

}  // namespace rectilin
