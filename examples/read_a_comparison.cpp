// Runs a small comparison of optimizers and reads its results back: the gap of every run to the proved optimum.
#include <cstdio>
#include <exception>

#include "rectilin/laboratory/comparison.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/optim/adapters/all_optimizers.h"

using namespace rectilin;

int main() try {
  laboratory::Plan plan;
  plan.meshes = {"shape:pyramid", "shape:filleted-cube"};
  plan.entries = laboratory::parse_entries({"ga, random, multistart"}, {"covering"}, all_optimizers());
  plan.runs = 5;
  plan.budget = 2000;
  laboratory::run_comparison(plan, "example-comparison", all_optimizers());  // finished runs in the folder are kept

  const laboratory::Results results = laboratory::load_results("example-comparison");
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh)
    for (std::size_t entry = 0; entry < plan.entries.size(); ++entry) {
      std::vector<double> gaps;
      for (const laboratory::RunResult* run : results.of(mesh, entry)) gaps.push_back(run->trace.final_gap());
      std::printf("%-16s %-12s median gap %.1e\n", results.meshes[mesh].title.c_str(),
                  plan.entries[entry].label.c_str(), laboratory::median(gaps));
    }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
