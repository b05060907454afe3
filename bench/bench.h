// The families of benchmarks; main.cpp runs those that the filter names. Names are paths of
// key:value pairs, which bench_report reads. Benchmarks of one thread count processor time, as
// others may use the machine; those of several threads count real time.
#pragma once

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <string>

namespace rectilin::bench {

void register_kernel_benchmarks();
void register_tree_benchmarks();
void register_mesh_benchmarks();
void register_search_benchmarks();
void register_proof_benchmarks();
void register_pose_benchmarks();
void register_view_benchmarks();
void register_retrieval_benchmarks();

/// Keeps TBB to so many threads while it lives.
inline tbb::global_control threads(int count) {
  return {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)};
}

inline std::string pair(const char* key, std::size_t value) {
  return std::string("/") + key + ":" + std::to_string(value);
}

/// `total` of the whole run, divided by its time.
inline benchmark::Counter rate(double total) { return {total, benchmark::Counter::kIsRate}; }

}  // namespace rectilin::bench
