// An optimizer of one's own: an options struct, a class, and a line that adds it to a copy of the
// registry.
#include "rectilin/optim/local.h"
#include "support/catch.h"
#include "support/known_shapes.h"

namespace {

using namespace rectilin;

struct DownhillOptions {
  double step = 0.3;
  void bind(Parameters& table) { table.real("step", step, 1e-9, 1, "first length of a turn, radians"); }
};

/// Random turns that are kept if they help; the step grows by successes and shrinks by failures.
class Downhill final : public LocalOptimizerWith<DownhillOptions> {
 public:
  using Options = DownhillOptions;
  static constexpr const char* kName = "downhill";

  explicit Downhill(Options options = {}) : LocalOptimizerWith(options) {}
  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false, .local = true}; }

  void improve(const Rotation& start, Evaluator& evaluator, const Domain&, Random& random) const override {
    Rotation at = start;
    double value = evaluator.value(at);
    for (double step = options_.step; step > 1e-9 && !evaluator.exhausted();) {
      const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
      const Rotation next = rotation_from_vector(step * turn) * at;
      const double found = evaluator.value(next);
      step *= found < value ? 2 : 0.9;
      if (found < value) at = next, value = found;
    }
  }
};

}  // namespace

TEST_CASE("an optimizer of one's own works alone, in a pipeline and in multistart", "[example]") {
  Registry registry = builtin_optimizers();
  registry.add<Downhill>("random turns that are kept if they help");
  for (const char* spec : {"downhill?step=0.1", "super-fibonacci?count=100+downhill", "multistart?local=downhill"}) {
    const RunRecord record = run_optimizer(*registry.make(spec), test::pyramid(), {.budget = {.evaluations = 20000}});
    REQUIRE(record.merit == Approx(test::kPyramid).margin(1e-5));
  }
}
