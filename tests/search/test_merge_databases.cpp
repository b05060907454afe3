// Databases of shards: they make the whole, in any order, any number of times; what differs is reported.
#include <algorithm>

#include "rectilin/search/index.h"
#include "rectilin/search/merge_databases.h"
#include "rectilin/search/status.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::search;
namespace fs = std::filesystem;

namespace {

constexpr const char* kMergedText = "d2?samples=500+r";

std::vector<std::string> some_shapes(int count) {
  std::vector<std::string> sources;
  for (int i = 0; i < count; ++i) sources.push_back("shape:prism?sides=" + std::to_string(i + 3));
  return sources;
}

void index_part(const fs::path& file, const std::vector<std::string>& sources, const corpus::Shard& shard) {
  Database database(file, kMergedText);
  IndexOptions options;
  options.shard = shard;
  update_index(database, sources, {}, options);
}

/// All that is kept, without ids and times.
std::vector<std::string> contents(const fs::path& file) {
  Database database(file);
  std::vector<std::string> lines;
  for (const Member& m : database.members()) {
    std::string line = m.name + ' ' + m.digest + ' ' + m.error + ' ' + std::to_string(static_cast<int>(m.status));
    for (const retrieval::Signature& part : database.signature(m.id)) line.append(part.begin(), part.end());
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

TEST_CASE("databases of shards make the whole") {
  const test::ScratchFolder scratch;
  std::vector<std::string> sources = some_shapes(20);
  sources.push_back((scratch.path() / "missing.off").string());
  index_part(scratch.path() / "whole.db", sources, {});
  std::vector<fs::path> parts;
  for (std::uint32_t i = 0; i < 3; ++i) {
    parts.push_back(scratch.path() / ("part" + std::to_string(i) + ".db"));
    index_part(parts.back(), sources, {i, 3});
  }
  const corpus::MergeSummary summary = merge_databases(parts, scratch.path() / "all.db");
  CHECK(summary.rows == 21);
  CHECK(summary.added == 21);
  CHECK(summary.conflicts == 0);
  CHECK(contents(scratch.path() / "all.db") == contents(scratch.path() / "whole.db"));
  std::ranges::reverse(parts);
  CHECK(merge_databases(parts, scratch.path() / "all.db").added == 0);
  merge_databases(parts, scratch.path() / "other order.db");
  CHECK(contents(scratch.path() / "other order.db") == contents(scratch.path() / "whole.db"));
  const corpus::StoreStatus status = status_of(scratch.path() / "all.db");
  CHECK(status.done == 20);
  CHECK(status.failed == 1);
  CHECK(status.left == 0);

  SECTION("a shard leaves the members of others alone, and done ones need not be done again") {
    index_part(scratch.path() / "all.db", sources, {1, 5});
    CHECK(contents(scratch.path() / "all.db") == contents(scratch.path() / "whole.db"));
    Database rest(scratch.path() / "rest.db", kMergedText);
    IndexOptions options;
    options.done = {parts[0], parts[1]};
    const IndexSummary left = update_index(rest, sources, {}, options);
    CHECK(left.elsewhere + left.added + left.errors.size() == 21);
    // The file that is missing has no digest, by which it could be known.
    std::size_t known = 0;
    for (const fs::path& part : options.done)
      for (const Member& m : Database(part).members()) known += m.status == MemberStatus::kDone;
    CHECK(left.elsewhere == known);
  }

  SECTION("another signature for a member is a conflict, and the target keeps its own") {
    const auto before = contents(scratch.path() / "all.db");
    {
      Database database(parts[0], kMergedText);
      const std::vector<Member> members = database.members();
      // In this part may be the file that is missing, too, which has no signature.
      const Member first = *std::ranges::find(members, MemberStatus::kDone, &Member::status);
      Parts signature = database.signature(first.id);
      signature[0][0] ^= 1;
      database.put(first, &signature);
    }
    const std::vector<fs::path> changed = {parts[0]};
    const corpus::MergeSummary again = merge_databases(changed, scratch.path() / "all.db");
    CHECK(again.conflicts == 1);
    REQUIRE(again.first.size() == 1);
    CHECK(again.first[0].reason == "another result for the same mesh");
    CHECK(contents(scratch.path() / "all.db") == before);
  }
}

TEST_CASE("databases of other descriptors are not merged") {
  const test::ScratchFolder scratch;
  { Database database(scratch.path() / "a.db", "r"); }
  { Database database(scratch.path() / "b.db", "d2"); }
  const std::vector<fs::path> files = {scratch.path() / "a.db", scratch.path() / "b.db"};
  CHECK_THROWS_AS(merge_databases(files, scratch.path() / "all.db"), ParameterError);
  CHECK_FALSE(fs::exists(scratch.path() / "all.db"));
}
