// The vector loops of the flat sum, compiled once for each instruction set. foreach_target.h includes this file again
// for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums/flat_sum_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "sums/flat_sum_kernels.h"

#include <algorithm>

#include "hwy/cache_control.h"
#include "sums/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

// Number of directions that share one pass over a block. Each takes two registers for its slopes and one for each
// output of its sums; three more hold an area vector and one the projection. More directions would not fit into the
// registers, fewer would leave too few independent additions to hide their latency.
#if HWY_TARGET <= HWY_AVX3 || HWY_ARCH_ARM
constexpr int kRegisters = 32;
#else
constexpr int kRegisters = 16;
#endif
template <class Sum>
constexpr int kTogether = (Sum::kOutputs == 1 ? 8 : 4) * kRegisters / 32;

// A single rotation waits for memory. Requesting each array this many bytes ahead keeps more of it under way than the
// processor's own prefetching, which ends at every page (measured on Zen 5; 1024 and 4096 are worse).
constexpr int kFew = 3;
constexpr std::size_t kBytesAhead = 2048;

template <class T>
HWY_INLINE void prefetch_ahead(const VectorSpan<T>& faces, std::size_t i) {
  i += kBytesAhead / sizeof(T);
  hwy::Prefetch(faces.x + i);
  hwy::Prefetch(faces.y + i);
  hwy::Prefetch(faces.z + i);
}

// The sums of one direction, lane by lane; they stay in memory from block to block.
template <class D, class Sum>
constexpr std::size_t kLanes = Sum::kOutputs* hn::MaxLanes(D());

template <class D, class Sum, int kCount, class T>
HWY_NOINLINE void add_group(const VectorSpan<T>& faces, const Slope<T>* slopes, T* lanes) {
  const D d;
  hn::Vec<D> a[kCount], b[kCount];
  Sum sum[kCount];
  for (int k = 0; k < kCount; ++k) {
    a[k] = hn::Set(d, slopes[k].a);
    b[k] = hn::Set(d, slopes[k].b);
  }
  std::size_t i = 0;
  do {  // do, not while: knowing that there is at least one, the compiler keeps the sums in registers
    if (kCount <= kFew) prefetch_ahead(faces, i);
    const auto x = hn::LoadU(d, faces.x + i);
    const auto y = hn::LoadU(d, faces.y + i);
    const auto z = hn::LoadU(d, faces.z + i);
    for (int k = 0; k < kCount; ++k) sum[k].add(x, y, z, hn::MulAdd(a[k], x, hn::MulAdd(b[k], y, z)));
    i += hn::Lanes(d);
  } while (i < faces.size);
  for (int k = 0; k < kCount; ++k) sum[k].add_to_lanes(lanes + k * kLanes<D, Sum>);
}

// Does the last, smaller group, whose size is found by counting down from the largest possible.
template <class D, class Sum, int kCount, class T>
HWY_INLINE void add_rest(const VectorSpan<T>& faces, const Slope<T>* slopes, std::size_t directions, T* lanes) {
  if constexpr (kCount > 0) {
    if (directions == kCount) {
      add_group<D, Sum, kCount>(faces, slopes, lanes);
    } else {
      add_rest<D, Sum, kCount - 1>(faces, slopes, directions, lanes);
    }
  }
}

template <class D, class Sum, class T>
void add_block(const VectorSpan<T>& faces, const Slope<T>* slopes, std::size_t directions, T* lanes) {
  constexpr std::size_t kGroup = kTogether<Sum>;
  std::size_t k = 0;
  for (; k + kGroup <= directions; k += kGroup)
    add_group<D, Sum, kGroup>(faces, slopes + k, lanes + k * kLanes<D, Sum>);
  add_rest<D, Sum, kGroup - 1>(faces, slopes + k, directions - k, lanes + k * kLanes<D, Sum>);
}

template <class T, template <class> class DSum>
void kernel(const VectorSpan<T>& faces, const VectorSpan<T>& tail, const Slope<T>* slopes, std::size_t directions,
            double* sums) {
  using D = hn::ScalableTag<T>;
  using Sum = DSum<D>;
  HWY_ALIGN T lanes[kSlab * kLanes<D, Sum>];
  std::fill_n(lanes, directions * kLanes<D, Sum>, T{0});
  for (std::size_t begin = 0; begin < faces.size; begin += kBlock<T>) {
    const std::size_t end = std::min(begin + kBlock<T>, faces.size);
    add_block<D, Sum>(faces.slice(begin, end), slopes, directions, lanes);
  }
  if (tail.size > 0) add_block<D, Sum>(tail, slopes, directions, lanes);

  const D d;
  for (std::size_t i = 0; i < directions * Sum::kOutputs; ++i)
    sums[i] += lane_sum(d, hn::Load(d, lanes + i * hn::Lanes(d)));
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
