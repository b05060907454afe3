// The most similar members of a collection, found without comparing all of them in full.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rectilin/base/huge_pages.h"
#include "rectilin/retrieval/bounded.h"
#include "rectilin/retrieval/descriptor.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

struct Neighbour {
  std::size_t member;  ///< in the order of add()
  double distance;
  bool operator==(const Neighbour&) const = default;
};

/// How much work a search was.
struct NearestCosts {
  std::size_t bounded = 0;   ///< members for which a bound was computed: all that pass the filter
  std::size_t compared = 0;  ///< of these, compared in full
};

/// Signatures in memory, to be searched. The distance is that of make_descriptor(): the weighted mean of the terms',
/// each over its typical one.
///
/// Exact: the result is that of comparing the query with every member. Each member gets a lower bound first, from the
/// terms that are cheap to compare and, for terms that have coarse signatures (see retrieval::Bounded), from those;
/// members are then compared in the order of their bounds, until the next bound is above the n-th distance found.
class NearestSearch {
 public:
  /// Throws ParameterError.
  explicit NearestSearch(const std::string& descriptor);

  void reserve(std::size_t members);
  /// Sizes of parts are those of the terms' bytes(); else std::invalid_argument.
  void add(const Parts& parts);
  std::size_t size() const { return size_; }
  const std::string& descriptor() const { return text_; }
  Parts parts_of(std::size_t member) const;

  /// The n members nearest to the query for which `keep` is true, nearest first, equal ones in the order of add().
  /// Runs on all of TBB's threads with the same result for any number of them. Thread safe.
  std::vector<Neighbour> nearest(const Parts& query, std::size_t n, const std::function<bool(std::size_t)>& keep = {},
                                 NearestCosts* costs = nullptr) const;

  /// All members nearer than or as near as `radius`, nearest first. Exact, too.
  std::vector<Neighbour> within(const Parts& query, double radius, NearestCosts* costs = nullptr) const;

  double distance(const Parts& query, std::size_t member) const;

  /// The bound by which search goes, as a distance of its own between two members: cheap terms in full, the others by
  /// their coarse signatures. Symmetric, and at most the distance, up to rounding in the last bits. Where some term has
  /// neither, it is the distance itself.
  double rough_distance(std::size_t a, std::size_t b) const;
  /// The same between a query, prepared by rough(), and a member.
  double rough_distance(const Parts& query, const Parts& rough, std::size_t member) const;
  Parts rough(const Parts& query) const;

 private:
  struct Term {
    retrieval::DescriptorPointer descriptor;
    double factor;                                ///< of its distance in the sum
    std::size_t bytes;                            ///< of a signature
    bool cheap;                                   ///< compared with every member
    const retrieval::Bounded* bounded = nullptr;  ///< the descriptor, if its coarse signatures are used
    std::size_t rough_bytes = 0;                  ///< of a cheap signature, or of a coarse one
    std::size_t rough_offset = 0;                 ///< of these in a row of rough_
    HugePages<std::uint8_t> signatures;           ///< of terms that are not cheap
  };
  retrieval::SignatureView signature(const Term& term, std::size_t member) const;
  retrieval::SignatureView rough(const Term& term, std::size_t member) const;
  double bound(const Parts& query, const Parts& coarse, std::size_t member) const;
  std::vector<Neighbour> search(const Parts& query, std::size_t n, double radius,
                                const std::function<bool(std::size_t)>& keep, NearestCosts* costs) const;

  std::string text_;
  std::vector<Term> terms_;
  HugePages<std::uint8_t> rough_;  ///< what bounds need, a row for each member: few places in memory to wait for
  std::size_t row_ = 0;            ///< its length
  std::size_t size_ = 0;
  bool all_bounded_ = true;  ///< each term is cheap or has coarse signatures
};

}  // namespace rectilin::search
