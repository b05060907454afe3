// Exact nearest neighbours: against comparing everything with make_descriptor()'s own distance.
#include <tbb/global_control.h>

#include <algorithm>

#include "rectilin/base/random.h"
#include "rectilin/search/nearest.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::search;

namespace {

/// Bytes that may be signatures of a descriptor whose numbers are bytes.
Parts random_parts(const std::vector<std::size_t>& sizes, Random& random) {
  Parts parts;
  for (const std::size_t size : sizes) {
    retrieval::Signature s(size);
    const std::uint64_t range = 1 + random.below(255);  // so that some are much alike
    for (auto& byte : s) byte = static_cast<std::uint8_t>(random.below(range));
    parts.push_back(std::move(s));
  }
  return parts;
}

std::vector<std::size_t> sizes_of(const std::string& descriptor) {
  std::vector<std::size_t> sizes;
  for (const auto& term : retrieval::parse_composite(descriptor))
    sizes.push_back(retrieval::descriptors().make(term.spec)->bytes());
  return sizes;
}

retrieval::Signature joined(const Parts& parts) {
  retrieval::Signature all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

void check_exact(const std::string& text) {
  CAPTURE(text);
  const auto descriptor = retrieval::make_descriptor(text);
  const auto sizes = sizes_of(text);
  Random random(5);
  NearestSearch search(text);
  std::vector<Parts> members;
  for (int i = 0; i < 150; ++i) {
    // Every tenth is the same as the one before it: equal distances are in the order of add().
    members.push_back(i % 10 == 9 ? members.back() : random_parts(sizes, random));
    search.add(members.back());
  }
  for (int q = 0; q < 6; ++q) {
    const Parts query = q == 0 ? members[3] : random_parts(sizes, random);
    std::vector<Neighbour> all;
    for (std::size_t i = 0; i < members.size(); ++i)
      all.push_back({i, descriptor->distance(joined(query), joined(members[i]))});
    std::ranges::stable_sort(all, {}, &Neighbour::distance);
    NearestCosts costs;
    const auto found = search.nearest(query, 12, {}, &costs);
    REQUIRE(found.size() == 12);
    CHECK(costs.bounded == 150);
    CHECK(costs.compared >= 12);
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k].distance == Approx(all[k].distance).epsilon(1e-12));
      CHECK(found[k].member == all[k].member);
    }
    const auto odd = search.nearest(query, 5, [](std::size_t i) { return i % 2 == 1; });
    std::erase_if(all, [](const Neighbour& n) { return n.member % 2 == 0; });
    for (std::size_t k = 0; k < odd.size(); ++k) CHECK(odd[k].member == all[k].member);
    const auto near = search.within(query, found[7].distance);
    CHECK(near.size() >= 8);
    for (const Neighbour& n : near) CHECK(n.distance <= found[7].distance);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(search.nearest(query, 12) == found);
  }
}

}  // namespace

TEST_CASE("the nearest members are those of a full comparison, ties in order") {
  check_exact("gsmd?views=6");
  check_exact("gsmd?views=18+0.5*gsmd?views=6");
}

TEST_CASE("more neighbours than members, and no members") {
  NearestSearch search("gsmd?views=6");
  Random random(1);
  const Parts query = random_parts(sizes_of("gsmd?views=6"), random);
  CHECK(search.nearest(query, 5).empty());
  search.add(query);
  const auto found = search.nearest(query, 5);
  REQUIRE(found.size() == 1);
  CHECK(found[0].distance == 0);
  CHECK_THROWS_AS(search.add({retrieval::Signature(3)}), std::invalid_argument);
}
