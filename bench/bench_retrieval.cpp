// What descriptors cost: to describe a model, and to compare two, in one run so that ratios mean something.
#include <memory>

#include "bench.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/descriptor.h"

namespace rectilin::bench {
namespace {

using retrieval::DescriptorPointer;
using retrieval::Model;
using retrieval::Signature;

constexpr const char* kShape = "shape:blob?faces=7000";  // the mean of the Princeton Shape Benchmark
constexpr const char* kOther = "shape:torus";

void describe(benchmark::State& state, const std::string& spec) {
  const auto limit = threads(1);
  const DescriptorPointer descriptor = retrieval::make_descriptor(spec);
  const Model model(load_mesh(kShape).mesh);
  descriptor->describe(model);  // finds the pose, which is not the descriptor's own work
  for (auto _ : state) benchmark::DoNotOptimize(descriptor->describe(model));
}

void compare(benchmark::State& state, const std::string& spec) {
  const DescriptorPointer descriptor = retrieval::make_descriptor(spec);
  const Signature a = descriptor->describe(Model(load_mesh(kShape).mesh));
  const Signature b = descriptor->describe(Model(load_mesh(kOther).mesh));
  for (auto _ : state) benchmark::DoNotOptimize(descriptor->distance(a, b));
}

}  // namespace

void register_retrieval_benchmarks() {
  for (const char* spec : {"d1", "d2", "aad", "sprh", "shd", "gsmd?views=6", "gsmd?views=18", "gsmd?views=66",
                           "gsmd?views=66&image=silhouette", "gsmd?views=258", "lfd", "lfd:ntu"}) {
    const std::string name(spec);
    benchmark::RegisterBenchmark(("describe/" + name).c_str(), [name](auto& state) {
      describe(state, name);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("compare/" + name).c_str(), [name](auto& state) {
      compare(state, name);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace rectilin::bench
