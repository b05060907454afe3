// An optimizer of one's own: an options struct, a function, and a line that adds it to a copy of the registry.
#include "rectilin/optim/registry.h"
#include "support/catch.h"
#include "support/known_shapes.h"

namespace {

using namespace rectilin;

struct DownhillOptions {
  double step = 0.3;
  void bind(Parameters& table) { table.real("step", step, 1e-9, 1, "first length of a turn, radians"); }
};

/// Random turns that are kept if they help; the step grows by successes and shrinks by failures.
void downhill(const DownhillOptions& options, const Rotation& start, Evaluator& evaluator, const Domain&,
              Random& random) {
  Rotation at = start;
  double value = evaluator.value(at);
  for (double step = options.step; step > 1e-9 && !evaluator.exhausted();) {
    const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
    const Rotation next = rotation_from_vector(step * turn) * at;
    const double found = evaluator.value(next);
    step *= found < value ? 2 : 0.9;
    if (found < value) at = next, value = found;
  }
}

}  // namespace

TEST_CASE("an optimizer of one's own works alone, in a pipeline and in multistart", "[example]") {
  Registry registry = builtin_optimizers();
  registry.add(LocalMethod<DownhillOptions>{.name = "downhill",
                                            .help = "random turns that are kept if they help",
                                            .capabilities = {.uses_domain = false},
                                            .improve = downhill});
  for (const char* spec : {"downhill?step=0.1", "super-fibonacci?count=100+downhill", "multistart?local=downhill"}) {
    const RunRecord record = run_optimizer(*registry.make(spec), test::pyramid(), {.budget = {.evaluations = 20000}});
    REQUIRE(record.merit == Approx(test::kPyramid).margin(1e-5));
  }
}
