// Writes an optimizer and runs it like the built-in ones. It takes a struct of settings with their ranges, a function
// that searches, and one line that adds it.
#include <cstdio>

#include "rectilin/measure/measure.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/optim/registry.h"

using namespace rectilin;

namespace {

struct DownhillOptions {
  double step = 0.3;
  void bind(Parameters& table) { table.real("step", step, 1e-9, 1, "first length of a turn, radians"); }
};

/// Random turns that are kept if they help. All values come from the evaluator: it counts them, keeps the best
/// rotation, and says infinity when the budget is spent.
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

int main() {
  Registry registry = builtin_optimizers();
  registry.add(LocalMethod<DownhillOptions>{.name = "downhill",
                                            .help = "random turns that are kept if they help",
                                            .capabilities = {.uses_domain = false},
                                            .improve = downhill});

  const Mesh mesh = make_shape(Spec::parse("pyramid?rotate=random"));
  const double best = measure(mesh, measure_options("certify?gap=1e-10")).bounds->upper;
  for (const char* spec :
       {"downhill", "downhill?step=0.05", "super-fibonacci?count=100+downhill", "multistart?local=downhill", "ga"}) {
    MeasureOptions options = measure_options(spec, registry);
    options.run.budget.evaluations = 10'000;
    const Rectilinearity found = measure(mesh, options);
    std::printf("%-36s falls short of the proved optimum by %.1e after %llu evaluations\n", spec, best - found.value,
                static_cast<unsigned long long>(found.run.costs.evaluations()));
  }
}
