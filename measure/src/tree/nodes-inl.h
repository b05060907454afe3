// The nodes of a direction tree in vector registers, lists of them, and requests to memory. Compiled once for each
// instruction set, hence Highway's special include guard.
#if defined(RECTILIN_TREE_NODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RECTILIN_TREE_NODES_INL_H
#undef RECTILIN_TREE_NODES_INL_H
#else
#define RECTILIN_TREE_NODES_INL_H
#endif

#include <algorithm>
#include <bit>

#include "hwy/highway.h"
#include "rectilin/base/set_bits.h"
#include "tree/direction_tree_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kFan>;
using V = hn::Vec<D>;
using D64 = hn::RebindToUnsigned<D>;
using D32 = hn::CappedTag<std::uint32_t, kFan>;

// On large trees most visits miss the caches, so memory is requested kFar nodes ahead into the second-level cache, and
// kNear nodes ahead into the first. A core can wait for far fewer lines of the first than of the second: with a single
// request into the first a tree of ten million vectors takes 1.6 times as long (Zen 4).
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

/// A list of nodes.
class NodeList {
 public:
  HWY_INLINE explicit NodeList(std::uint32_t* nodes) : nodes_(nodes) {}

  /// Appends first + j for every set bit j of `bits`. Writes up to kFan entries past the end.
  HWY_INLINE void append(std::uint32_t first, unsigned bits) {
    const D32 d;
    const hn::Rebind<std::uint8_t, D32> d8;
    for (std::size_t lane = 0; lane < kFan; lane += hn::Lanes(d)) {
      const auto places = hn::PromoteTo(d, hn::LoadU(d8, kSetBits[bits].data() + lane));
      hn::StoreU(hn::Add(hn::Set(d, first), places), d, nodes_ + size_ + lane);
    }
    size_ += static_cast<std::size_t>(std::popcount(bits));
  }

  std::size_t size() const { return size_; }

 private:
  std::uint32_t* nodes_;
  std::size_t size_ = 0;
};

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
