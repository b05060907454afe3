#include "rectilin/search/nearest.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rectilin/retrieval/best.h"

namespace rectilin::search {
namespace {

using retrieval::Bounded;
using retrieval::SignatureView;

constexpr std::size_t kCheapBytes = 600;  // a term of so few bytes is compared with every member
constexpr double kRoundingSlack = 1e-12;  // bounds and distances are sums in different orders

bool nearer(const Neighbour& a, const Neighbour& b) {
  return a.distance < b.distance || (a.distance == b.distance && a.member < b.member);
}

}  // namespace

NearestSearch::NearestSearch(const std::string& descriptor) : text_(retrieval::without_alias(descriptor)) {
  double total = 0;
  const std::vector<retrieval::Term> terms = retrieval::parse_composite(text_);
  for (const retrieval::Term& term : terms) {
    Term t;
    t.descriptor = retrieval::descriptors().make(term.spec);
    // A single descriptor's distance is its own; a sum's is scaled.
    t.factor = terms.size() == 1 ? 1 : term.weight / t.descriptor->typical_distance();
    total += term.weight;
    t.bytes = t.descriptor->bytes();
    t.cheap = t.bytes <= kCheapBytes;
    t.bounded = t.cheap ? nullptr : dynamic_cast<const Bounded*>(t.descriptor.get());
    t.rough_bytes = t.cheap ? t.bytes : t.bounded ? t.bounded->coarse_bytes() : 0;
    t.rough_offset = row_;
    row_ += t.rough_bytes;
    all_bounded_ &= t.cheap || t.bounded;
    terms_.push_back(std::move(t));
  }
  if (terms.size() > 1)
    for (Term& t : terms_) t.factor /= total;
}

void NearestSearch::reserve(std::size_t members) {
  rough_.reserve(members * row_);
  for (Term& t : terms_)
    if (!t.cheap) t.signatures.reserve(members * t.bytes);
}

void NearestSearch::add(const Parts& parts) {
  if (parts.size() != terms_.size()) throw std::invalid_argument("a signature of another descriptor");
  for (std::size_t k = 0; k < terms_.size(); ++k)
    if (parts[k].size() != terms_[k].bytes) throw std::invalid_argument("a signature of another descriptor");
  const auto append = [](HugePages<std::uint8_t>& to, const retrieval::Signature& what) {
    to.insert(to.end(), what.begin(), what.end());
  };
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    Term& t = terms_[k];
    if (t.bounded) append(rough_, t.bounded->coarse(parts[k]));
    append(t.cheap ? rough_ : t.signatures, parts[k]);
  }
  ++size_;
}

Parts NearestSearch::parts_of(std::size_t member) const {
  Parts parts;
  for (const Term& t : terms_) {
    const SignatureView own = signature(t, member);
    parts.emplace_back(own.begin(), own.end());
  }
  return parts;
}

SignatureView NearestSearch::signature(const Term& t, std::size_t member) const {
  return t.cheap ? rough(t, member) : SignatureView(t.signatures.data() + member * t.bytes, t.bytes);
}

SignatureView NearestSearch::rough(const Term& t, std::size_t member) const {
  return {rough_.data() + member * row_ + t.rough_offset, t.rough_bytes};
}

double NearestSearch::distance(const Parts& query, std::size_t member) const {
  double sum = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    sum += terms_[k].factor * terms_[k].descriptor->distance(query[k], signature(terms_[k], member));
  return sum;
}

double NearestSearch::bound(const Parts& query, const Parts& sums, std::size_t member) const {
  double sum = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Term& t = terms_[k];
    if (t.cheap) sum += t.factor * t.descriptor->distance(query[k], signature(t, member));
    else if (t.bounded) sum += t.factor * t.bounded->bound(sums[k], rough(t, member));
  }
  return sum;
}

double NearestSearch::rough_distance(const Parts& query, const Parts& sums, std::size_t member) const {
  for (std::size_t i = 0; i < row_; i += 64) __builtin_prefetch(rough_.data() + member * row_ + i);
  return all_bounded_ ? bound(query, sums, member) : distance(query, member);
}

double NearestSearch::rough_distance(std::size_t a, std::size_t b) const {
  // The members come in no order, so all of a row is asked for before the first byte is waited for.
  for (std::size_t i = 0; i < row_; i += 64) {
    __builtin_prefetch(rough_.data() + a * row_ + i);
    __builtin_prefetch(rough_.data() + b * row_ + i);
  }
  double sum = 0;
  for (const Term& t : terms_)
    sum += t.factor * (all_bounded_ && t.bounded ? t.bounded->bound(rough(t, a), rough(t, b))
                                                 : t.descriptor->distance(signature(t, a), signature(t, b)));
  return sum;
}

Parts NearestSearch::rough(const Parts& query) const {
  Parts sums;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    sums.push_back(terms_[k].bounded ? terms_[k].bounded->coarse(query[k]) : retrieval::Signature());
  return sums;
}

std::vector<Neighbour> NearestSearch::search(const Parts& query, std::size_t n, double radius,
                                             const std::function<bool(std::size_t)>& keep, NearestCosts* costs) const {
  const Parts sums = rough(query);
  std::vector<Neighbour> bounds(size_);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size_, 512), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      bounds[i] = {i, keep && !keep(i) ? std::numeric_limits<double>::infinity() : bound(query, sums, i)};
  });
  if (keep) std::erase_if(bounds, [](const Neighbour& b) { return std::isinf(b.distance); });
  if (costs) *costs = {bounds.size(), 0};

  // A heap gives the members in the order of their bounds without sorting those that are never asked for.
  const auto later = [](const Neighbour& a, const Neighbour& b) { return nearer(b, a); };
  std::ranges::make_heap(bounds, later);
  std::vector<Neighbour> best, batch;
  std::size_t batch_size = std::max<std::size_t>(2 * std::min(n, bounds.size()), 16);
  while (n > 0 && !bounds.empty()) {
    const double limit = best.size() < n ? radius : std::min(radius, best.back().distance);
    batch.clear();
    while (!bounds.empty() && batch.size() < batch_size) {
      const Neighbour& first = bounds.front();
      if (first.distance > limit + kRoundingSlack * std::abs(limit)) break;
      batch.push_back(first);
      std::ranges::pop_heap(bounds, later);
      bounds.pop_back();
    }
    if (batch.empty()) break;
    tbb::parallel_for(std::size_t{0}, batch.size(),
                      [&](std::size_t i) { batch[i].distance = distance(query, batch[i].member); });
    if (costs) costs->compared += batch.size();
    for (const Neighbour& b : batch)
      if (b.distance <= radius) best.push_back(b);
    std::ranges::sort(best, nearer);
    if (best.size() > n) best.resize(n);
    batch_size = 64;
  }
  return best;
}

std::vector<Neighbour> NearestSearch::nearest(const Parts& query, std::size_t n,
                                              const std::function<bool(std::size_t)>& keep, NearestCosts* costs) const {
  return search(query, n, std::numeric_limits<double>::infinity(), keep, costs);
}

std::vector<Neighbour> NearestSearch::within(const Parts& query, double radius, NearestCosts* costs) const {
  return search(query, size_, radius, {}, costs);
}

}  // namespace rectilin::search
