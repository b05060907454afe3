// The vector loops of the flat sum, compiled once for each instruction set.
// foreach_target.h includes this file again for every instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flat_sum_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include <algorithm>

#include "flat_kernels.h"
#include "flat_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

// Directions that share one pass over a block. Each takes two registers for its slopes and one per
// output for its sums; three more hold a face vector and one the projection. More directions would
// spill, fewer would leave too few independent additions to cover their latency.
#if HWY_TARGET <= HWY_AVX3 || HWY_ARCH_ARM
constexpr int kRegisters = 32;
#else
constexpr int kRegisters = 16;
#endif
template <class Sum>
constexpr int kTogether = (Sum::kOutputs == 1 ? 8 : 4) * kRegisters / 32;

template <class D, class Sum, int kCount>
struct Group {
  using T = hn::TFromD<D>;
  hn::Vec<D> a[kCount], b[kCount];
  Sum sum[kCount];

  HWY_INLINE explicit Group(const Slope<T>* slopes) {
    for (int k = 0; k < kCount; ++k) {
      a[k] = hn::Set(D(), slopes[k].a);
      b[k] = hn::Set(D(), slopes[k].b);
    }
  }

  HWY_INLINE void add(const FaceSpan<T>& faces) {
    const D d;
    for (std::size_t i = 0; i < faces.size; i += hn::Lanes(d)) {
      const auto x = hn::LoadU(d, faces.x + i);
      const auto y = hn::LoadU(d, faces.y + i);
      const auto z = hn::LoadU(d, faces.z + i);
      for (int k = 0; k < kCount; ++k) {
        sum[k].add(x, y, z, hn::MulAdd(a[k], x, hn::MulAdd(b[k], y, z)));
      }
    }
  }
};

template <class D, class Sum, int kCount, class T>
HWY_NOINLINE void add_group(const FaceSpan<T>& faces, const FaceSpan<T>& tail,
                            const Slope<T>* slopes, double* sums) {
  Group<D, Sum, kCount> group(slopes);
  group.add(faces);
  group.add(tail);
  for (int k = 0; k < kCount; ++k) group.sum[k].add_to(sums + k * Sum::kOutputs);
}

// The last, smaller group, found by counting down from the largest possible.
template <class D, class Sum, int kCount, class T>
HWY_INLINE void add_rest(const FaceSpan<T>& faces, const FaceSpan<T>& tail, const Slope<T>* slopes,
                         std::size_t directions, double* sums) {
  if constexpr (kCount > 0) {
    if (directions == kCount) {
      add_group<D, Sum, kCount>(faces, tail, slopes, sums);
    } else {
      add_rest<D, Sum, kCount - 1>(faces, tail, slopes, directions, sums);
    }
  }
}

template <class Sum, class D, class T>
void add_sums(const FaceSpan<T>& faces, const FaceSpan<T>& tail, const Slope<T>* slopes,
              std::size_t directions, double* sums) {
  constexpr std::size_t kGroup = kTogether<Sum>;
  std::size_t begin = 0;
  do {  // at least once: there may be nothing but a tail
    const std::size_t end = std::min(begin + kBlock<T>, faces.size);
    const FaceSpan<T> block = faces.slice(begin, end);
    const FaceSpan<T> rest = tail.slice(0, end == faces.size ? tail.size : 0);
    std::size_t k = 0;
    for (; k + kGroup <= directions; k += kGroup) {
      add_group<D, Sum, kGroup>(block, rest, slopes + k, sums + k * Sum::kOutputs);
    }
    add_rest<D, Sum, kGroup - 1>(block, rest, slopes + k, directions - k, sums + k * Sum::kOutputs);
    begin = end;
  } while (begin < faces.size);
}

template <class T, template <class> class Sum>
void kernel(const FaceSpan<T>& faces, const FaceSpan<T>& tail, const Slope<T>* slopes,
            std::size_t directions, double* sums) {
  using D = hn::ScalableTag<T>;
  add_sums<Sum<D>, D>(faces, tail, slopes, directions, sums);
}

const FlatKernels* kernels() {
  static constexpr FlatKernels table = {
      {kernel<float, NegativePart>, kernel<float, NegativeSum>, kernel<float, TotalSum>},
      {kernel<double, NegativePart>, kernel<double, NegativeSum>, kernel<double, TotalSum>}};
  return &table;
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(kernels);

const FlatKernels& flat_kernels() { return *HWY_DYNAMIC_DISPATCH(kernels)(); }

}  // namespace rectilin
#endif
