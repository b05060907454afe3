#include "corpus/fixtures.h"
#include "rectilin/corpus/merge.h"
#include "rectilin/corpus/store.h"

using namespace rectilin;
using namespace rectilin::corpus;
using namespace rectilin::test;

namespace {

const Task kMergedTask{"test", Json::object()};

Row row_of(const std::string& name, RowStatus status, const std::string& result) {
  Row row;
  row.name = row.source = name;
  row.status = status;
  if (status == RowStatus::kDone) row.digest = "digest of " + name;
  row.result = result;
  return row;
}

std::filesystem::path store_of(const std::filesystem::path& file, const std::vector<Row>& rows) {
  Store store(file, kMergedTask);
  for (const Row& row : rows) store.put(row);
  return file;
}

}  // namespace

TEST_CASE("of two rows the one that says more is taken, in any order, any number of times", "[corpus]") {
  const ScratchFolder folder;
  using enum RowStatus;
  const auto a = store_of(folder.path() / "a.db", {row_of("1", kDone, "{}"), row_of("2", kLimited, ""),
                                                   row_of("3", kLeft, ""), row_of("5", kFailed, "")});
  const auto b =
      store_of(folder.path() / "b.db", {row_of("1", kDone, "{}"), row_of("2", kDone, "{}"), row_of("3", kFailed, ""),
                                        row_of("4", kDone, "{}"), row_of("5", kLimited, "")});
  const std::vector<std::filesystem::path> ab = {a, b}, ba = {b, a};
  const MergeSummary summary = merge(ab, folder.path() / "ab.db");
  CHECK(summary.rows == 5);
  CHECK(summary.conflicts == 0);
  merge(ba, folder.path() / "ba.db");
  const auto rows = rows_of(folder.path() / "ab.db");
  CHECK(rows == rows_of(folder.path() / "ba.db"));
  CHECK(rows[1].status == kDone);
  CHECK(rows[2].status == kFailed);
  CHECK(rows[4].status == kFailed);
  CHECK(merge(ab, folder.path() / "ab.db").added == 0);
  CHECK(rows == rows_of(folder.path() / "ab.db"));
}

TEST_CASE("results that differ are reported, and the first stays", "[corpus]") {
  const ScratchFolder folder;
  using enum RowStatus;
  Row other_mesh = row_of("2", kDone, "{}");
  other_mesh.digest = "another";
  const auto a = store_of(folder.path() / "a.db", {row_of("1", kDone, R"({"x":1})"), row_of("2", kDone, "{}")});
  const auto b = store_of(folder.path() / "b.db", {row_of("1", kDone, R"({"x":2})"), other_mesh});
  const std::vector<std::filesystem::path> stores = {a, b};
  const MergeSummary summary = merge(stores, folder.path() / "all.db");
  REQUIRE(summary.conflicts == 2);
  CHECK(summary.first[0].name == "1");
  CHECK(summary.first[0].reason == "another result for the same mesh");
  CHECK(summary.first[1].reason == "another mesh has this name");
  CHECK(rows_of(folder.path() / "all.db") == rows_of(a));
}

TEST_CASE("stores of other tasks do not mix", "[corpus]") {
  const ScratchFolder folder;
  const auto a = store_of(folder.path() / "a.db", {});
  { Store store(folder.path() / "b.db", Task{"other", Json::object()}); }
  const std::vector<std::filesystem::path> stores = {a, folder.path() / "b.db"};
  CHECK_THROWS_AS(merge(stores, folder.path() / "all.db"), ParameterError);
  CHECK_THROWS_AS(merge(std::vector{a}, a), ParameterError);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "all.db"));
}
