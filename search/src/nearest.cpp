#include "rectilin/search/nearest.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rectilin/retrieval/bounded.h"

namespace rectilin::search {
namespace {

using retrieval::Bounded;
using retrieval::SignatureView;

constexpr std::size_t kCheapBytes = 600;  // a term of so few bytes is compared with every member
constexpr double kRoundingSlack = 1e-12;  // bounds and distances are sums in different orders

bool nearer(const Neighbour& a, const Neighbour& b) {
  return a.distance < b.distance || (a.distance == b.distance && a.member < b.member);
}

const Bounded* as_bounded(const retrieval::DescriptorPointer& descriptor) {
  return dynamic_cast<const Bounded*>(descriptor.get());
}

}  // namespace

NearestSearch::NearestSearch(const std::string& descriptor) {
  double total = 0;
  const std::vector<retrieval::Term> terms = retrieval::parse_composite(descriptor);
  for (const retrieval::Term& term : terms) {
    Term t;
    t.descriptor = retrieval::descriptors().make(term.spec);
    // A single descriptor's distance is its own; a sum's is scaled.
    t.factor = terms.size() == 1 ? 1 : term.weight / t.descriptor->typical_distance();
    total += term.weight;
    t.bytes = t.descriptor->bytes();
    t.cheap = t.bytes <= kCheapBytes;
    if (const Bounded* bounded = as_bounded(t.descriptor); bounded && !t.cheap)
      t.coarse_bytes = bounded->coarse_bytes();
    terms_.push_back(std::move(t));
  }
  if (terms.size() > 1)
    for (Term& t : terms_) t.factor /= total;
}

void NearestSearch::reserve(std::size_t members) {
  for (Term& t : terms_) {
    t.signatures.reserve(members * t.bytes);
    t.coarse.reserve(members * t.coarse_bytes);
  }
}

void NearestSearch::add(const Parts& parts) {
  if (parts.size() != terms_.size()) throw std::invalid_argument("a signature of another descriptor");
  for (std::size_t k = 0; k < terms_.size(); ++k)
    if (parts[k].size() != terms_[k].bytes) throw std::invalid_argument("a signature of another descriptor");
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    Term& t = terms_[k];
    t.signatures.insert(t.signatures.end(), parts[k].begin(), parts[k].end());
    if (t.coarse_bytes == 0) continue;
    const retrieval::Signature coarse = as_bounded(t.descriptor)->coarse(parts[k]);
    t.coarse.insert(t.coarse.end(), coarse.begin(), coarse.end());
  }
  ++size_;
}

Parts NearestSearch::parts_of(std::size_t member) const {
  Parts parts;
  for (const Term& t : terms_) {
    const std::uint8_t* begin = t.signatures.data() + member * t.bytes;
    parts.emplace_back(begin, begin + t.bytes);
  }
  return parts;
}

double NearestSearch::distance(const Parts& query, std::size_t member) const {
  double sum = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Term& t = terms_[k];
    sum += t.factor * t.descriptor->distance(query[k], SignatureView(t.signatures.data() + member * t.bytes, t.bytes));
  }
  return sum;
}

double NearestSearch::bound(const Parts& query, const Parts& coarse, std::size_t member) const {
  double sum = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Term& t = terms_[k];
    if (t.cheap)
      sum +=
          t.factor * t.descriptor->distance(query[k], SignatureView(t.signatures.data() + member * t.bytes, t.bytes));
    else if (t.coarse_bytes > 0)
      sum +=
          t.factor * as_bounded(t.descriptor)
                         ->bound(coarse[k], SignatureView(t.coarse.data() + member * t.coarse_bytes, t.coarse_bytes));
  }
  return sum;
}

std::vector<Neighbour> NearestSearch::search(const Parts& query, std::size_t n, double radius,
                                             const std::function<bool(std::size_t)>& keep, NearestCosts* costs) const {
  Parts coarse;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    coarse.push_back(terms_[k].coarse_bytes > 0 ? as_bounded(terms_[k].descriptor)->coarse(query[k])
                                                : retrieval::Signature());
  std::vector<Neighbour> bounds(size_);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size_, 512), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      bounds[i] = {i, keep && !keep(i) ? std::numeric_limits<double>::infinity() : bound(query, coarse, i)};
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
