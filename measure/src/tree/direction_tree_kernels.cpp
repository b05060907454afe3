// The vector loops of the direction tree, compiled once for each instruction set. foreach_target.h includes this file
// again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tree/direction_tree_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "tree/direction_tree_kernels.h"

#include <algorithm>

#include "sums/cap-inl.h"
#include "sums/lanes-inl.h"
#include "tree/nodes-inl.h"
#include "tree/twig-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

template <class Sum, bool kCutOff>
class Walk {
 public:
  HWY_INLINE Walk(const DirectionTreeNodes& nodes, const DirectionQuery& query, TwoSum* sums)
      : nodes_(nodes), query_(query), sums_(sums) {}

  /// Lists all nodes of a level that are to be opened before it visits the next level. The processor then works on many
  /// nodes at once and never waits for a branch, as it would at each node of a depth-first walk; and too long a list is
  /// noticed before its nodes cost anything.
  HWY_INLINE bool run() {
    std::uint32_t lists[2][kMostOpened + kChunkNodes + kFan];
    lists[0][0] = 0;
    std::size_t size = 1;
    int current = 0;
    for (int level = nodes_.depth - 1; level >= 0; --level, current = 1 - current) {
      if constexpr (kTwigs) {
        if (level == 0 && query_.twigs != nullptr && !add_twigs(lists[current], size, lists[1 - current])) return false;
      }
      size = test(level, lists[current], size, lists[1 - current]);
      if (size > nodes_.limits[level]) return false;
    }
    add_leaves(lists[current], size);
    return true;
  }

 private:
  static constexpr bool kTwigs = Sum::kOutputs == 1 && !kCutOff;

  /// Sums what is below nodes of level 1 by their twigs and leaves in the list those that have none; or does nothing if
  /// twigs would not be accurate enough. Returns false if the circle meets too many leaves.
  HWY_INLINE bool add_twigs(std::uint32_t* list, std::size_t& size, std::uint32_t* spare) {
    TwigSum twigs(nodes_, query_);
    NodeList wide(spare);
    TwoSum sum = sums_[0];
    twigs.add(list, size, sum, wide);
    if (twigs.met() > nodes_.limits[0]) return false;
    if (twigs.widths() > nodes_.widths) return true;
    sums_[0] = sum;
    std::copy_n(spare, wide.size(), list);
    size = wide.size();
    return true;
  }

  /// Sums the nodes that the circle misses and lists those that it meets; stops when these become too many.
  HWY_INLINE std::size_t test(int level, const std::uint32_t* families, std::size_t size, std::uint32_t* children) {
    NodeList found(children);
    request_first(nodes_.levels[level], families, size);
    for (std::size_t begin = 0; begin < size && found.size() <= nodes_.limits[level];) {
      const std::size_t end = std::min(size, begin + kChunkNodes / kFan);
      test_chunk(nodes_.levels[level], families, begin, end, size, found);
      flush();
      begin = end;
    }
    return found.size();
  }

  HWY_INLINE void test_chunk(const DirectionFamily* nodes, const std::uint32_t* families, std::size_t begin,
                             std::size_t end, std::size_t size, NodeList& found) {
    const D d;
    const auto a = hn::Set(d, query_.slope.a), b = hn::Set(d, query_.slope.b);
    const auto reach = hn::Set(d, query_.reach), resolution = hn::Set(d, query_.resolution);
    Sum sum = sum_;
    for (std::size_t i = begin; i < end; ++i) {
      request_ahead(nodes, families, i, size);
      unsigned bits = 0;
      for (std::size_t lane = 0; lane < kFan; lane += hn::Lanes(d)) {
        const auto [v, radius] = load_family(nodes[families[i]], lane);
        const auto s = hn::MulAdd(a, v.x, hn::MulAdd(b, v.y, v.z));
        auto meets = hn::Lt(hn::Abs(s), hn::Mul(radius, reach));
        if (kCutOff) {
          const auto least = hn::Mul(squared_length(v.x, v.y, v.z), resolution);
          meets = hn::And(meets, hn::Gt(hn::Mul(radius, radius), least));
        }
        sum.add(v.x, v.y, v.z, hn::IfThenZeroElse(meets, s));
        std::uint8_t byte[8] = {};
        hn::StoreMaskBits(d, meets, byte);
        bits |= static_cast<unsigned>(byte[0]) << lane;
      }
      found.append(families[i] * static_cast<std::uint32_t>(kFan), bits);
    }
    sum_ = sum;
  }

  HWY_INLINE void add_leaves(const std::uint32_t* leaves, std::size_t size) {
    request_first(nodes_.leaves, leaves, size);
    for (std::size_t begin = 0; begin < size;) {
      const std::size_t end = std::min(size, begin + kChunkNodes);
      add_chunk(leaves, begin, end, size);
      flush();
      begin = end;
    }
  }

  HWY_INLINE void add_chunk(const std::uint32_t* leaves, std::size_t begin, std::size_t end, std::size_t size) {
    const D d;
    const auto a = hn::Set(d, query_.slope.a), b = hn::Set(d, query_.slope.b);
    const auto unit = hn::Set(D64(), nodes_.unit);
    Sum sum = sum_;
    for (std::size_t i = begin; i < end; ++i) {
      request_ahead(nodes_.leaves, leaves, i, size);
      for (std::size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
        const Vectors v = load_leaf(nodes_.leaves[leaves[i]], lane, unit);
        sum.add(v.x, v.y, v.z, hn::MulAdd(a, v.x, hn::MulAdd(b, v.y, v.z)));
      }
    }
    sum_ = sum;
  }

  HWY_INLINE void flush() {
    double part[Sum::kOutputs] = {};
    sum_.add_to(part);
    for (int i = 0; i < Sum::kOutputs; ++i) sums_[i].add(part[i]);
    sum_ = Sum();
  }

  const DirectionTreeNodes& nodes_;
  const DirectionQuery query_;
  TwoSum* sums_;
  Sum sum_;
};

template <class Sum>
bool kernel(const DirectionTreeNodes& nodes, const DirectionQuery& query, TwoSum* sums) {
  return query.resolution > 0 ? Walk<Sum, true>(nodes, query, sums).run() : Walk<Sum, false>(nodes, query, sums).run();
}

double cap(const DirectionTreeNodes& nodes, std::size_t begin, std::size_t end, const double* axis) {
  const D d;
  const auto ax = hn::Set(d, axis[0]), ay = hn::Set(d, axis[1]), az = hn::Set(d, axis[2]);
  auto largest = hn::Zero(d);
  const auto unit = hn::Set(D64(), nodes.unit);
  for (std::size_t leaf = begin; leaf < end; ++leaf)
    for (std::size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
      const auto [x, y, z] = load_leaf(nodes.leaves[leaf], lane, unit);
      largest = hn::Max(largest, squared_sine(d, x, y, z, ax, ay, az));
    }
  return hn::GetLane(hn::MaxOfLanes(d, largest));
}

const DirectionTreeKernels* normal_kernel_table() {
  static constexpr DirectionTreeKernels table = {kernel<NegativePart<D>>, kernel<NegativeSum<D>>, cap};
  return &table;
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(normal_kernel_table);

const DirectionTreeKernels& normal_kernels() { return *HWY_DYNAMIC_DISPATCH(normal_kernel_table)(); }

}  // namespace rectilin
#endif
