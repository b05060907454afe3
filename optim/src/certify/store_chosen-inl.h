// Keeps some lanes of a vector register. Compiled once for each instruction set, hence Highway's special include guard.
#if defined(RECTILIN_STORE_CHOSEN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RECTILIN_STORE_CHOSEN_INL_H
#undef RECTILIN_STORE_CHOSEN_INL_H
#else
#define RECTILIN_STORE_CHOSEN_INL_H
#endif

#include <cstdint>

#include "hwy/highway.h"
#include "rectilin/base/set_bits.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::certification::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Writes the lanes of a mask next to each other; what follows them, up to a whole register, becomes anything. For
/// lanes of four or eight bytes.
///
/// It is Highway's Compress, whose version 1.0 has its tables on the stack: compilers copy half a kilobyte to two for
/// each vector. Its CompressStore has none with AVX-512, but a Zen 4 takes long to compress into memory.
template <class D>
HWY_INLINE void store_chosen(D d, hn::Vec<D> v, hn::Mask<D> mask, hn::TFromD<D>* to) {
#if HWY_TARGET == HWY_SCALAR  // a single lane
  (void)mask;
  hn::StoreU(v, d, to);
#else
  const hn::Repartition<std::uint32_t, D> d32;
  const auto chosen = hn::MaskFromVec(hn::BitCast(d32, hn::VecFromMask(d, mask)));
#if HWY_TARGET <= HWY_AVX3
  const auto first = hn::Compress(hn::BitCast(d32, v), chosen);  // has an instruction, and needs no table
#else
  const hn::Rebind<std::uint8_t, decltype(d32)> d8;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d32, chosen, bits);
  const auto places = hn::PromoteTo(d32, hn::LoadU(d8, kSetBits[bits[0]].data()));
  const auto first = hn::TableLookupLanes(hn::BitCast(d32, v), hn::IndicesFromVec(d32, places));
#endif
  hn::StoreU(hn::BitCast(d, first), d, to);
#endif
}

}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
