// Journals whose last line was cut off, and others that are damaged.
#include <filesystem>

#include "rectilin/base/journal.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;

TEST_CASE("a journal without its cut line goes on") {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "runs.jsonl";
  REQUIRE(recover_journal(file).empty());
  Journal(file).append({{"run", 1}});
  const auto whole = std::filesystem::file_size(file);
  std::ofstream(file, std::ios::app) << "{\"run\": 2";
  REQUIRE(recover_journal(file) == std::vector<Json>{{{"run", 1}}});
  REQUIRE(std::filesystem::file_size(file) == whole);
  Journal(file).append({{"run", 3}});
  REQUIRE(recover_journal(file) == std::vector<Json>{{{"run", 1}}, {{"run", 3}}});
}

TEST_CASE("a whole line that is not JSON is named") {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "runs.jsonl";
  std::ofstream(file) << "{\"run\": 1}\n{\"run\": \n{\"run\": 3}\n";
  REQUIRE_THROWS_WITH(recover_journal(file), file.string() + ":line 2: not JSON");
}
