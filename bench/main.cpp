// Runs the benchmarks: bench [Google Benchmark's options], e.g. --benchmark_filter='^flat/AVX2'
#include <benchmark/benchmark.h>

#include "bench.h"

int main(int argc, char** argv) {
  using namespace rectilin::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_kernel_benchmarks();
  register_tree_benchmarks();
  register_mesh_benchmarks();
  register_search_benchmarks();
  register_proof_benchmarks();
  register_pose_benchmarks();
  register_view_benchmarks();
  register_retrieval_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
