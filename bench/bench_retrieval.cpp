// What descriptors cost: to describe a model, and to compare two, in one run so that ratios mean something.
#include <time.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "bench.h"
#include "rectilin/base/random.h"
#include "rectilin/mesh/source.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/retrieval/descriptor.h"
#include "rectilin/retrieval/distance_matrix.h"

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

std::vector<Signature> random_signatures(const retrieval::Descriptor& descriptor, std::size_t count) {
  Random random(1);
  std::vector<Signature> signatures(count, Signature(descriptor.bytes()));
  for (Signature& signature : signatures)
    for (auto& byte : signature) byte = static_cast<std::uint8_t>(random.below(63));  // as floats, numbers below 1
  return signatures;
}

/// Of this thread.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Two pieces of work taken in turns, `together` times each, so that whatever else the machine does slows both: the
/// ratio of their processor times means more than either.
template <class First, class Second>
void in_turns(benchmark::State& state, int together, const First& first, const Second& second) {
  double one = 0, other = 0;
  for (auto _ : state) {
    const double begin = processor_seconds();
    for (int i = 0; i < together; ++i) benchmark::DoNotOptimize(first());
    const double middle = processor_seconds();
    for (int i = 0; i < together; ++i) benchmark::DoNotOptimize(second());
    one += middle - begin;
    other += processor_seconds() - middle;
  }
  const double n = static_cast<double>(state.iterations()) * together;
  state.counters["first_us"] = 1e6 * one / n;
  state.counters["second_us"] = 1e6 * other / n;
  state.counters["ratio"] = one / other;
}

/// LFD over GSMD_66: the paper has 11,642 us over 154 us, 76.
void lfd_over_gsmd(benchmark::State& state) {
  const DescriptorPointer lfd = retrieval::make_descriptor("lfd"), gsmd = retrieval::make_descriptor("gsmd?views=66");
  const auto a = random_signatures(*lfd, 2), b = random_signatures(*gsmd, 2);
  in_turns(
      state, 16, [&] { return lfd->distance(a[0], a[1]); }, [&] { return gsmd->distance(b[0], b[1]); });
}

/// Eq. (33) as it stands, 47 numbers of single precision a view in plain loops, over what the house does.
void plain_over_gsmd(benchmark::State& state) {
  constexpr std::size_t kViews = 66, kNumbers = 47;
  const DescriptorPointer gsmd = retrieval::make_descriptor("gsmd?views=66");
  const auto bytes = random_signatures(*gsmd, 2);
  const render::ViewSphere sphere = render::ViewSphere::of_size(kViews);
  std::array<std::vector<float>, 2> numbers;
  Random random(2);
  for (auto& list : numbers)
    for (std::size_t i = 0; i < kViews * kNumbers; ++i) list.push_back(static_cast<float>(random.uniform(0, 1)));
  const auto plain = [&] {
    float least = std::numeric_limits<float>::infinity();
    for (const auto& permutation : sphere.permutations()) {
      float sum = 0;
      for (std::size_t k = 0; k < kViews; ++k)
        for (std::size_t i = 0; i < kNumbers; ++i)
          sum += std::abs(numbers[0][k * kNumbers + i] - numbers[1][permutation[k] * kNumbers + i]);
      least = std::min(least, sum);
    }
    return least;
  };
  in_turns(state, 16, plain, [&] { return gsmd->distance(bytes[0], bytes[1]); });
}

/// Describing a model by GSMD_66 over drawing its 66 views alone.
void describing_over_drawing(benchmark::State& state) {
  const auto limit = threads(1);
  const DescriptorPointer gsmd = retrieval::make_descriptor("gsmd?views=66");
  const Model model(load_mesh(kShape).mesh);
  const Mesh& posed = model.posed("rectilinear");
  const render::ViewSphere sphere = render::ViewSphere::of_size(66);
  in_turns(
      state, 1, [&] { return gsmd->describe(model).size(); },
      [&] {
        return render::render_views(posed, render::Ball{Vector3::Zero(), 1}, sphere).size();
      });
}

/// All pairs of as many models as the benchmark's training half has, on one thread.
void all_pairs(benchmark::State& state, const std::string& spec) {
  const auto limit = threads(1);
  const DescriptorPointer descriptor = retrieval::make_descriptor(spec);
  const auto signatures = random_signatures(*descriptor, 904);
  for (auto _ : state)
    benchmark::DoNotOptimize(retrieval::symmetric_matrix(signatures.size(), [&](std::size_t i, std::size_t j) {
      return descriptor->distance(signatures[i], signatures[j]);
    }));
}

}  // namespace

void register_retrieval_benchmarks() {
  benchmark::RegisterBenchmark("compare_ratio/lfd/gsmd_66", lfd_over_gsmd)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("compare_ratio/plain/gsmd_66", plain_over_gsmd)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("describe_ratio/gsmd_66/drawing", describing_over_drawing)
      ->Unit(benchmark::kMillisecond);
  for (const char* spec : {"gsmd?views=66", "gsmd?views=66+0.5*shd+0.15*r"})
    benchmark::RegisterBenchmark((std::string("all_pairs/904/") + spec).c_str(), [spec](auto& state) {
      all_pairs(state, spec);
    })->Unit(benchmark::kMillisecond);
  for (const char* spec : {"d1", "d2", "aad", "sprh", "shd", "swc", "dla", "gsmd?views=6", "gsmd?views=18",
                           "gsmd?views=66", "gsmd?views=66&image=silhouette", "gsmd?views=258", "lfd", "lfd:ntu"}) {
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
