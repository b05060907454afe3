// The approximate search: how much of the exact one it finds, and that its file is worth nothing that it should not be.
#include <algorithm>
#include <fstream>
#include <set>

#include "rectilin/base/random.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/search/approximate.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::search;
using rectilin::test::ScratchFolder;

namespace {

constexpr const char* kDescriptor = "views+0.25*extents";  // one term with a bound, one that is compared in full

std::vector<std::size_t> graph_sizes() {
  std::vector<std::size_t> sizes;
  for (const auto& term : retrieval::parse_composite(kDescriptor))
    sizes.push_back(retrieval::descriptors().make(term.spec)->bytes());
  return sizes;
}

/// Bytes like those of signatures: some of a few families, each shifted by what its members have in common.
Parts family_parts(std::uint64_t seed) {
  static const std::vector<std::size_t> sizes = graph_sizes();
  Random random(seed);
  Random family(1000 + random.below(60));
  const double share = random.uniform();
  Parts parts;
  for (const std::size_t size : sizes) {
    retrieval::Signature s(size);
    for (auto& byte : s) {
      const double common = static_cast<double>(family.below(200)), own = static_cast<double>(random.below(200));
      byte = static_cast<std::uint8_t>(common + 0.3 * share * (own - common));
    }
    parts.push_back(std::move(s));
  }
  return parts;
}

struct Members {
  NearestSearch search{kDescriptor};
  std::vector<std::int64_t> ids;
  void add(const Parts& parts, std::int64_t id) {
    search.add(parts);
    ids.push_back(id);
  }
};

Members some_members(std::size_t count) {
  Members members;
  for (std::size_t i = 0; i < count; ++i) members.add(family_parts(i), static_cast<std::int64_t>(i + 1));
  return members;
}

std::string built_bytes(const Members& members) {
  ApproximateSearch graph(members.search, members.ids);
  REQUIRE(graph.build());
  return graph.bytes();
}

}  // namespace

TEST_CASE("the graph finds nearly all of the nearest, with exact distances") {
  const Members members = some_members(6000);
  ApproximateSearch graph(members.search, members.ids);
  REQUIRE(graph.build());
  REQUIRE(graph.nodes() == 6000);
  std::size_t found_of_them = 0;
  const int queries = 50;
  for (std::uint64_t q = 0; q < queries; ++q) {
    const Parts query = family_parts(1'000'000 + q);
    const auto exact = members.search.nearest(query, 20);
    const auto found = graph.nearest(query, 20);
    REQUIRE(found.size() == 20);
    CHECK(std::ranges::is_sorted(found, {}, &Neighbour::distance));
    for (const Neighbour& n : found) {
      CHECK(n.distance == members.search.distance(query, n.member));
      found_of_them += std::ranges::find(exact, n) != exact.end();
    }
    // A filter: those that pass are ranked as if there were no others.
    const auto third = [](std::size_t i) { return i % 3 != 0; };
    const auto kept = graph.nearest(query, 5, third);
    REQUIRE(kept.size() == 5);
    for (const Neighbour& n : kept) CHECK(third(n.member));
    CHECK(kept.front().distance >= exact.front().distance);
    // Few pass: found all the same, and exactly.
    const auto rare = [](std::size_t i) { return i % 1000 == 7; };
    CHECK(graph.nearest(query, 10, rare) == members.search.nearest(query, 10, rare));
  }
  CHECK(found_of_them >= 20 * queries * 97 / 100);
  CHECK(graph.nearest(family_parts(5), 7000).size() == 6000);
  CHECK(graph.nearest(family_parts(5), 0).empty());
  // A member is its own nearest.
  for (std::size_t i = 0; i < 6000; i += 500)
    CHECK(graph.nearest(members.search.parts_of(i), 1) == std::vector<Neighbour>{{i, 0.0}});
}

TEST_CASE("copies of one file do not shut out the rest, and stand in order") {
  Members members = some_members(5000);
  for (std::int64_t i = 0; i < 500; ++i) members.add(family_parts(17), 10'000 + i);
  ApproximateSearch graph(members.search, members.ids);
  REQUIRE(graph.build());
  CHECK(graph.nodes() == 5000);
  const auto found = graph.nearest(family_parts(17), 100);
  CHECK(found == members.search.nearest(family_parts(17), 100));
  CHECK(found.front().member == 17);
  CHECK(found.back().member == 5098);
  const Parts other = family_parts(2'000'000);
  CHECK(graph.nearest(other, 3) == members.search.nearest(other, 3));
}

TEST_CASE("a shape and its variations can all be reached") {
  Members members = some_members(4500);
  const Parts shape = family_parts(3'000'000);
  constexpr std::size_t kShape = 4500, kVariations = 1500;
  std::int64_t id = kShape;
  members.add(shape, ++id);
  for (std::uint64_t i = 0; i < kVariations; ++i) {
    Random random(i);
    Parts parts = shape;
    for (auto& part : parts)
      for (auto& byte : part)
        byte = static_cast<std::uint8_t>(std::clamp(byte + static_cast<int>(random.below(13)) - 6, 0, 255));
    members.add(parts, ++id);
  }
  // What makes it hard: each variation is nearer to the shape than to any other variation.
  for (std::size_t i = kShape + 1; i < members.search.size(); i += 50)
    REQUIRE(members.search.nearest(members.search.parts_of(i), 2).back().member == kShape);
  ApproximateSearch graph(members.search, members.ids);
  REQUIRE(graph.build());
  std::size_t reached = 0;
  for (std::size_t i = kShape; i < members.search.size(); ++i)
    reached += graph.walk(members.search.parts_of(i), 1, 512).front() == Neighbour{i, 0.0};
  CAPTURE(reached);
  CHECK(reached * 100 >= (kVariations + 1) * 95);  // by hnswlib's own rule 14 %
}

TEST_CASE("the graph is the same bytes each time, in one go or in parts, whatever the order of names") {
  const Members members = some_members(700);
  const std::string bytes = built_bytes(members);
  CHECK(built_bytes(members) == bytes);
  Members shuffled;  // the same ids with the same signatures at other places
  for (std::size_t k = 0; k < 700; ++k) {
    const std::size_t i = k * 211 % 700;
    shuffled.add(members.search.parts_of(i), members.ids[i]);
  }
  CHECK(built_bytes(shuffled) == bytes);

  const ScratchFolder folder;
  const auto file = folder.path() / "graph";
  Members fewer = some_members(650);
  ApproximateSearch first(fewer.search, fewer.ids);
  REQUIRE(first.build());
  first.save(file);
  ApproximateSearch more(members.search, members.ids);
  CHECK(more.load(file) == GraphFile::kTaken);
  CHECK(more.nodes() == 650);
  CHECK_FALSE(more.complete());
  CHECK_THROWS_AS(more.nearest(family_parts(1), 3), std::logic_error);
  REQUIRE(more.build());
  CHECK(more.bytes() == bytes);

  // Stopped in the middle: what is there is worth keeping.
  std::stop_source stop;
  ApproximateSearch stopped(members.search, members.ids);
  CHECK_FALSE(stopped.build({stop.get_token(), [&](std::size_t done, std::size_t total, const std::string&) {
                               CHECK(total == 700);
                               if (done >= 256) stop.request_stop();
                             }}));
  CHECK(stopped.nodes() > 256);
  CHECK(stopped.nodes() < 400);
  stopped.save(file);
  ApproximateSearch again(members.search, members.ids);
  CHECK(again.load(file) == GraphFile::kTaken);
  REQUIRE(again.build());
  CHECK(again.bytes() == bytes);
}

TEST_CASE("a graph of other members is not taken") {
  const Members members = some_members(300);
  const ScratchFolder folder;
  const auto file = folder.path() / "graph";
  ApproximateSearch graph(members.search, members.ids);
  CHECK(graph.load(file) == GraphFile::kMissing);
  REQUIRE(graph.build());
  graph.save(file);
  Members removed, changed;
  for (std::size_t i = 0; i < 300; ++i) {
    if (i != 150) removed.add(members.search.parts_of(i), members.ids[i]);
    changed.add(i == 150 ? family_parts(999'999) : members.search.parts_of(i), members.ids[i]);
  }
  for (const Members* other : {&removed, &changed}) {
    ApproximateSearch without(other->search, other->ids);
    CHECK(without.load(file) == GraphFile::kOther);
    CHECK(without.nodes() == 0);
    std::string note;
    const auto opened = open_approximate(other->search, other->ids, file, {}, note);
    CHECK(note.empty());
    CHECK(read_whole_file(file) == built_bytes(*other));
    CHECK(opened->nearest(family_parts(3), 5) == other->search.nearest(family_parts(3), 5));
  }
}

TEST_CASE("damaged files of a graph are noticed, those of another kind left alone") {
  const Members members = some_members(120);
  const std::string bytes = built_bytes(members);
  const ScratchFolder folder;
  const auto file = folder.path() / "graph";
  ApproximateSearch graph(members.search, members.ids);
  for (std::size_t size = 0; size < bytes.size(); size += size < 80 ? 1 : 97) {
    CAPTURE(size);
    write_whole_file(file, bytes.substr(0, size));
    CHECK(graph.load(file) == GraphFile::kDamaged);
  }
  write_whole_file(file, bytes + "x");
  CHECK(graph.load(file) == GraphFile::kDamaged);
  for (std::size_t at = 16; at < bytes.size(); at += 13) {
    CAPTURE(at);
    std::string wrong = bytes;
    wrong[at] = static_cast<char>(wrong[at] ^ 4);
    write_whole_file(file, wrong);
    CHECK(graph.load(file) == GraphFile::kDamaged);
  }
  std::string note;
  CHECK(open_approximate(members.search, members.ids, file, {}, note)->complete());
  CHECK(note.find("is damaged") != std::string::npos);
  CHECK(read_whole_file(file) == bytes);

  write_whole_file(file, "somebody's notes on graphs");
  CHECK_THROWS_WITH(graph.load(file), Catch::Contains("no graph of neighbours"));
  CHECK_THROWS_AS(open_approximate(members.search, members.ids, file, {}, note), std::runtime_error);
  CHECK(read_whole_file(file) == "somebody's notes on graphs");
}

TEST_CASE("a graph of no members, and of one") {
  for (const std::size_t count : {0u, 1u}) {
    const Members members = some_members(count);
    const ScratchFolder folder;
    const auto file = folder.path() / "graph";
    ApproximateSearch graph(members.search, members.ids);
    REQUIRE(graph.build());
    graph.save(file);
    ApproximateSearch again(members.search, members.ids);
    CHECK(again.load(file) == GraphFile::kTaken);
    CHECK(again.nearest(family_parts(0), 3).size() == count);
  }
}
