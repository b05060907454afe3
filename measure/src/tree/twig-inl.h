// Queries of twigs. Compiled once for each instruction set, hence Highway's special include guard.
#if defined(RECTILIN_TREE_TWIG_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RECTILIN_TREE_TWIG_INL_H
#undef RECTILIN_TREE_TWIG_INL_H
#else
#define RECTILIN_TREE_TWIG_INL_H
#endif

#include <algorithm>
#include <bit>

#include "hwy/highway.h"
#include "sums/lanes-inl.h"
#include "tree/nodes-inl.h"
#include "tree/twig.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

/// A whole number in units of 2^-kPlaces: it becomes the end of a larger number, whose last bit is worth one unit and
/// which is then taken away, with `offset`.
template <int kPlaces>
HWY_INLINE V whole(hn::Vec<D64> bits, double offset) {
  const D d;
  constexpr auto kLarge = static_cast<double>(std::uint64_t{1} << (52 - kPlaces));
  return hn::Sub(hn::BitCast(d, hn::Or(bits, hn::BitCast(D64(), hn::Set(d, kLarge)))), hn::Set(d, kLarge + offset));
}

/// The sum of min(u . v, 0) over the vectors below some nodes of level 1.
class TwigSum {
 public:
  HWY_INLINE TwigSum(const DirectionTreeNodes& nodes, const DirectionQuery& query) : nodes_(nodes), query_(query) {}

  /// Adds the sum over the nodes of `list` that are narrow to `sum` and writes the others to `wide`. Stops as soon as
  /// met() is over the limit of level 0.
  ///
  /// Chunk by chunk the circle is tested against the leaves; those of the chunk before that it meets are summed
  /// meanwhile, so that each of them has been requested long enough ago.
  HWY_INLINE void add(const std::uint32_t* list, std::size_t size, TwoSum& sum, NodeList& wide) {
    for (std::size_t i = 0; i < std::min(kFar, size); ++i) request_sums<kSecond>(list[i]);
    Chunk chunks[2];
    std::size_t current = 0;
    for (std::size_t begin = 0; begin < size && met_ <= nodes_.limits[0]; begin += kChunkTwigs, current = 1 - current) {
      test(list, begin, std::min(size, begin + kChunkTwigs), size, chunks[current], wide);
      add_leaves(chunks[1 - current], chunks[current], sum);
      met_ += chunks[current].count;
    }
    chunks[current].count = 0;
    add_leaves(chunks[1 - current], chunks[current], sum);
  }

  /// Number of leaves that the circle meets.
  std::size_t met() const { return met_; }

  /// The error of the sum, as the sum of |V| sin(radius) that it would be of leaves that are met (see kTwigError).
  HWY_INLINE double widths() const { return lane_sum(D(), widths_); }

 private:
  static constexpr std::size_t kChunkTwigs = kChunkNodes / kFan;

  /// What a query has to know of some nodes and of their leaves. For a vector below one of them u . w is share (s + R p
  /// first + R q second), with R = |V| sin(radius).
  struct Chunk {
    HWY_ALIGN double node_s[kChunkTwigs], node_radius[kChunkTwigs], first[kChunkTwigs], second[kChunkTwigs];
    HWY_ALIGN double s[kChunkNodes], radius[kChunkNodes];
    std::uint32_t leaves[kChunkNodes + kFan], lines[kChunkNodes + kFan];  // the leaves that are met, and their vectors
    std::size_t count = 0;
  };

  HWY_INLINE void test(const std::uint32_t* list, std::size_t begin, std::size_t end, std::size_t size, Chunk& chunk,
                       NodeList& wide) {
    write_nodes(list + begin, end - begin, chunk, wide);
    NodeList leaves(chunk.leaves), lines(chunk.lines);
    for (std::size_t i = begin; i < end; ++i) {
      request_sums<kSecond>(list[std::min(i + kFar, size - 1)]);
      request_sums<kFirst>(list[std::min(i + kNear, size - 1)]);
      const std::size_t k = i - begin;
      const unsigned met = test_twig(query_.twigs[list[i]], k, chunk);
      leaves.append(static_cast<std::uint32_t>(kFan * k), met);
      lines.append(static_cast<std::uint32_t>(kTwigLines * list[i] + kFirstLeafLine), met);
    }
    chunk.count = leaves.size();
  }

  /// What the nodes of a list are for this query; all zeros for those that are not narrow.
  HWY_INLINE void write_nodes(const std::uint32_t* list, std::size_t size, Chunk& chunk, NodeList& wide) {
    const D d;
    const V a = hn::Set(d, query_.slope.a), b = hn::Set(d, query_.slope.b), one = hn::Set(d, 1.0);
    for (std::size_t k = 0; k < size; k += kFan) {
      DirectionFamily chosen;
      std::uint32_t ids[kFan];
      for (std::size_t j = 0; j < kFan; ++j) {
        ids[j] = list[std::min(k + j, size - 1)];
        const DirectionFamily& family = nodes_.levels[1][ids[j] / kFan];
        for (std::size_t c = 0; c < 3; ++c) chosen.sums[c][j] = family.sums[c][ids[j] % kFan];
      }
      unsigned not_narrow = 0;
      for (std::size_t lane = 0; lane < kFan; lane += hn::Lanes(d)) {
        const auto [sum, radius] = load_family(chosen, lane);
        const V x = hn::Abs(sum.x), y = hn::Abs(sum.y), z = hn::Abs(sum.z);
        const auto along_x = hn::Ge(x, hn::Max(y, z)), along_z = hn::Gt(z, hn::Max(x, y));
        const auto narrow = hn::Le(hn::Mul(radius, hn::Set(d, kNarrow)), hn::Max(x, hn::Max(y, z)));
        const auto store = [&](V v, double* to)
                               HWY_ATTR { hn::Store(hn::IfThenElseZero(narrow, v), d, to + k + lane); };
        store(hn::MulAdd(a, sum.x, hn::MulAdd(b, sum.y, sum.z)), chunk.node_s);
        store(radius, chunk.node_radius);
        store(hn::IfThenElse(along_x, b, a), chunk.first);
        store(hn::IfThenElse(along_z, b, one), chunk.second);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Not(narrow), bits);
        not_narrow |= static_cast<unsigned>(bits[0]) << lane;
      }
      for (unsigned bits = not_narrow & ((1u << std::min(kFan, size - k)) - 1); bits != 0; bits &= bits - 1)
        wide.append(ids[std::countr_zero(bits)], 1);
    }
  }

  /// Sums the leaves that the circle misses. Returns a bit for each that it meets.
  HWY_INLINE unsigned test_twig(const Twig& twig, std::size_t k, Chunk& chunk) {
    const D d;
    const hn::Rebind<std::int32_t, D> d32;
    const hn::Rebind<float, D> df;
    const double radius = chunk.node_radius[k], step = kNodeShare * kNodeStep * radius;
    const V s = hn::Set(d, kNodeShare * chunk.node_s[k]), reach = hn::Set(d, query_.reach);
    const V first = hn::Set(d, step * chunk.first[k]), second = hn::Set(d, step * chunk.second[k]);
    V sum = sum_, widths = hn::Add(widths_, hn::Set(d, kNodeError / kFan * radius));
    unsigned met = 0;
    for (std::size_t lane = 0; lane < kFan; lane += hn::Lanes(d)) {
      const V share = hn::PromoteTo(d, hn::Load(d32, twig.shares + lane));
      const V p = hn::PromoteTo(d, hn::Load(d32, twig.first + lane));
      const V q = hn::PromoteTo(d, hn::Load(d32, twig.second + lane));
      const V own = hn::Mul(hn::Set(d, radius), hn::PromoteTo(d, hn::Load(df, twig.radii + lane)));
      const V term = hn::Mul(share, hn::MulAdd(first, p, hn::MulAdd(second, q, s)));
      const auto meets = hn::Lt(hn::Abs(term), hn::Mul(own, reach));
      sum = hn::Add(sum, hn::Min(hn::IfThenZeroElse(meets, term), hn::Zero(d)));
      widths = add_if(d, meets, widths, own);
      hn::Store(term, d, chunk.s + kFan * k + lane);
      hn::Store(own, d, chunk.radius + kFan * k + lane);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, meets, bits);
      met |= static_cast<unsigned>(bits[0]) << lane;
    }
    sum_ = sum;
    widths_ = widths;
    return met;
  }

  /// Sums the leaves of a chunk that are met, and requests those of the next.
  HWY_INLINE void add_leaves(const Chunk& chunk, const Chunk& next, TwoSum& total) {
    for (std::size_t i = chunk.count; i < next.count; ++i) request_vectors(next, i);
    V sum = sum_;
    for (std::size_t i = 0; i < chunk.count; ++i) {
      if (i < next.count) request_vectors(next, i);
      sum = hn::Add(sum, vectors_below(chunk, i));
    }
    total.add(lane_sum(D(), sum));
    sum_ = hn::Zero(D());
  }

  /// min(u . w, 0) summed, lane by lane, over the vectors of a leaf.
  HWY_INLINE V vectors_below(const Chunk& chunk, std::size_t i) {
    const D d;
    const D64 d64;
    constexpr std::uint64_t kMask = (std::uint64_t{1} << kStepBits) - 1;
    const std::size_t leaf = chunk.leaves[i];
    const V step = hn::Set(d, kVectorStep * chunk.radius[leaf]), s = hn::Set(d, chunk.s[leaf]);
    const V first = hn::Set(d, chunk.first[leaf / kFan]), second = hn::Set(d, chunk.second[leaf / kFan]);
    V sum = hn::Zero(d);
    for (std::size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
      const auto word = hn::Load(d64, vectors(chunk, i) + lane);
      const V p = whole<0>(hn::And(word, hn::Set(d64, kMask)), kMiddle);
      const V q = whole<kStepBits>(hn::And(word, hn::Set(d64, kMask << kStepBits)), kMiddle);
      const V share = whole<kShareBits>(hn::ShiftRight<2 * kStepBits>(word), 0);
      const V aside = hn::MulAdd(first, p, hn::Mul(second, q));
      sum = hn::Add(sum, hn::Min(hn::Mul(share, hn::MulAdd(step, aside, s)), hn::Zero(d)));
    }
    return sum;
  }

  HWY_INLINE const std::uint64_t* vectors(const Chunk& chunk, std::size_t i) const {
    return reinterpret_cast<const std::uint64_t*>(query_.twigs) + kLeaf * std::size_t{chunk.lines[i]};
  }

  HWY_INLINE void request_vectors(const Chunk& chunk, std::size_t i) const {
    __builtin_prefetch(vectors(chunk, i), 0, kSecond);
  }

  template <Cache kCache>
  HWY_INLINE void request_sums(std::uint32_t node) const {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(query_.twigs + node);
    for (std::size_t line = 0; line < kFirstLeafLine; ++line) __builtin_prefetch(bytes + 64 * line, 0, kCache);
  }

  const DirectionTreeNodes& nodes_;
  const DirectionQuery& query_;
  V sum_ = hn::Zero(D()), widths_ = hn::Zero(D());
  std::size_t met_ = 0;
};

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
