#include <fstream>

#include "corpus/fixtures.h"
#include "rectilin/corpus/status.h"
#include "rectilin/corpus/store.h"

using namespace rectilin;
using namespace rectilin::corpus;
using namespace rectilin::test;

namespace {

const Task kTask{"test", {{"a", 1}}};

Row done_row(const std::string& name, double r) {
  Row row;
  row.name = row.source = name;
  row.status = RowStatus::kDone;
  row.digest = "digest of " + name;
  row.result = to_text(Json{{"faces", 12}, {"rectilinearity", r}});
  row.report = "{}";
  row.version = "1";
  row.finished = 5;
  row.seconds = 0.25;
  return row;
}

}  // namespace

TEST_CASE("a store gives back what was put into it", "[corpus]") {
  const ScratchFolder folder;
  const auto file = folder.path() / "store.db";
  const Row row = done_row("it's \"a\" name, with\nlines and \xff bytes", 0.1);
  {
    Store store(file, kTask);
    store.put(row);
    CHECK_THROWS_WITH(Store(file, kTask), Catch::Matchers::Contains("another program is writing"));
    CHECK(Store(file).find(row.name) == row);  // while it is written
  }
  Store store(file);
  CHECK(store.find(row.name) == row);
  CHECK(store.find_digest(row.digest) == row);
  CHECK_FALSE(store.find("another"));
  CHECK(store.task().settings == kTask.settings);
}

TEST_CASE("stores of other tasks, and files that are none, are refused", "[corpus]") {
  const ScratchFolder folder;
  { Store store(folder.path() / "store.db", kTask); }
  CHECK_THROWS_AS(Store(folder.path() / "store.db", Task{"test", {{"a", 2}}}), ParameterError);
  CHECK_THROWS_AS(Store(folder.path() / "store.db", Task{"other", {{"a", 1}}}), ParameterError);
  std::ofstream(folder.path() / "text.db")
      << "OFF\n3 1 0\n and so on, for more than a page of nothing that SQLite knows";
  CHECK_THROWS_AS(Store(folder.path() / "text.db"), std::runtime_error);
  CHECK_THROWS_AS(Store(folder.path() / "text.db", kTask), std::runtime_error);
  CHECK_THROWS_AS(Store(folder.path() / "missing.db"), std::runtime_error);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "missing.db"));
}

TEST_CASE("a run knows what is left, and only of its own meshes", "[corpus]") {
  const ScratchFolder folder;
  const auto file = folder.path() / "store.db";
  Store store(file, kTask);
  const std::vector<NamedSource> meshes = {{"a", "a", ""}, {"b", "b", ""}, {"c", "c", ""}};
  CHECK(store.begin_run(meshes, {}, false) == std::vector<std::size_t>{0, 1, 2});
  store.put(done_row("b", 0.5));
  Row limited = done_row("c", 0.5);
  limited.status = RowStatus::kLimited;
  store.put(limited);
  CHECK(status_of(file).left == 1);
  CHECK(status_of(file).limited == 1);
  CHECK(status_of(file).running);
  CHECK(store.begin_run(meshes, {}, false) == std::vector<std::size_t>{0});
  CHECK(store.begin_run(meshes, {}, true) == std::vector<std::size_t>{0, 2});
  const std::vector<NamedSource> others = {{"b", "b", ""}, {"d", "d", ""}};
  CHECK(store.begin_run(others, {}, false) == std::vector<std::size_t>{1});
  CHECK(store.size() == 2);  // a and c were only to be done
  const std::vector<NamedSource> twice = {{"e", "e1", ""}, {"e", "e2", ""}};
  CHECK_THROWS_AS(store.begin_run(twice, {}, false), ParameterError);
}
