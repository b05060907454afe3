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
#include <bit>

#include "sums/cap-inl.h"
#include "sums/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

using D = hn::CappedTag<double, kFan>;
using V = hn::Vec<D>;
using D64 = hn::RebindToUnsigned<D>;
using D32 = hn::CappedTag<std::uint32_t, kFan>;

// Number of nodes whose terms are summed in registers before they go to the compensated sums. It bounds the number of
// terms in a lane, and so the rounding error.
constexpr std::size_t kChunkNodes = 256;

// On large trees most visits miss the caches, so memory is requested kFar nodes ahead into the second-level cache, and
// kNear nodes ahead into the first. A core can wait for far fewer lines of the first than of the second: with a single
// request into the first a tree of ten million vectors takes 1.5 times as long (Zen 4).
constexpr std::size_t kFar = 40, kNear = 8;

struct Vectors {
  V x, y, z;
};

/// A component of the vectors `lane` and following of a leaf, in the leaf's unit.
HWY_INLINE V load_component(const DirectionLeaf& leaf, std::size_t c, std::size_t lane) {
  const D d;
  const hn::Rebind<std::int32_t, D> d32;
  const hn::Rebind<std::uint8_t, D> d8;
  const auto high = hn::PromoteTo(d, hn::Load(d32, leaf.high[c] + lane));
  const auto low = hn::PromoteTo(d, hn::PromoteTo(d32, hn::Load(d8, leaf.low[c] + lane)));
  return hn::MulAdd(high, hn::Set(d, 256.0), low);
}

HWY_INLINE Vectors load_leaf(const DirectionLeaf& leaf, std::size_t lane, hn::Vec<D64> unit) {
  const D d;
  const hn::Rebind<std::uint32_t, D> d32;
  const hn::Rebind<std::uint8_t, D> d8;
  const auto exponent = hn::PromoteTo(D64(), hn::PromoteTo(d32, hn::Load(d8, leaf.exponent + lane)));
  const auto scale = hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(unit, exponent)));
  return {hn::Mul(load_component(leaf, 0, lane), scale), hn::Mul(load_component(leaf, 1, lane), scale),
          hn::Mul(load_component(leaf, 2, lane), scale)};
}

struct Nodes {
  Vectors sum;
  V radius;
};

HWY_INLINE Nodes load_family(const DirectionFamily& family, std::size_t lane) {
  const D d;
  const D64 d64;
  const auto x = hn::Load(d64, family.sums[0] + lane);
  const auto y = hn::Load(d64, family.sums[1] + lane);
  const auto z = hn::Load(d64, family.sums[2] + lane);
  // The last byte of each component holds a byte of the radius; here one of its upper ones, below its sign.
  const auto radius = hn::Or(hn::ShiftRight<1>(hn::ShiftLeft<56>(x)),
                             hn::Or(hn::ShiftRight<9>(hn::ShiftLeft<56>(y)), hn::ShiftRight<17>(hn::ShiftLeft<56>(z))));
  return {{hn::BitCast(d, x), hn::BitCast(d, y), hn::BitCast(d, z)}, hn::BitCast(d, radius)};
}

enum Cache { kSecond = 2, kFirst = 3 };  // as in the processor's hint

template <Cache kCache, class Block>
HWY_INLINE void request(const Block& block) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&block);
  for (std::size_t i = 0; i < sizeof(Block); i += 64) __builtin_prefetch(bytes + i, 0, kCache);
}

/// Requests the first blocks of a list, before which no loop looks ahead.
template <class Block>
HWY_INLINE void request_first(const Block* blocks, const std::uint32_t* list, std::size_t size) {
  for (std::size_t i = 0; i < std::min(kFar, size); ++i) request<kSecond>(blocks[list[i]]);
  for (std::size_t i = 0; i < std::min(kNear, size); ++i) request<kFirst>(blocks[list[i]]);
}

/// Requests what the loop over a list that is at position i will need.
template <class Block>
HWY_INLINE void request_ahead(const Block* blocks, const std::uint32_t* list, std::size_t i, std::size_t size) {
  request<kSecond>(blocks[list[std::min(i + kFar, size - 1)]]);
  request<kFirst>(blocks[list[std::min(i + kNear, size - 1)]]);
}

/// Lists of nodes. The lane numbers are kept in memory: Highway's Iota would write them there one by one at each call,
/// and reading them back at once would stall.
class NodeList {
 public:
  HWY_INLINE explicit NodeList(std::uint32_t* nodes) : nodes_(nodes) {
    for (std::uint32_t lane = 0; lane < kFan; ++lane) lanes_[lane] = lane;
  }

  /// Appends first + j for every set bit j of `bits`. Writes up to kFan entries past the end.
  HWY_INLINE void append(std::uint32_t first, unsigned bits) {
    const D32 d;
    for (std::size_t lane = 0; lane < kFan; lane += hn::Lanes(d)) {
      const auto part = static_cast<std::uint8_t>((bits >> lane) & ((1u << hn::Lanes(d)) - 1));
      const auto ids = hn::Add(hn::Set(d, first), hn::Load(d, lanes_ + lane));
      hn::StoreU(hn::CompressBits(ids, &part), d, nodes_ + size_);
      size_ += static_cast<std::size_t>(std::popcount(part));
    }
  }

  std::size_t size() const { return size_; }

 private:
  std::uint32_t* nodes_;
  std::size_t size_ = 0;
  HWY_ALIGN std::uint32_t lanes_[kFan];
};

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
      size = test(level, lists[current], size, lists[1 - current]);
      if (size > nodes_.limits[level]) return false;
    }
    add_leaves(lists[current], size);
    return true;
  }

 private:
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
