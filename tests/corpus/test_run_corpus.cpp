#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "corpus/fixtures.h"
#include "rectilin/base/random.h"
#include "rectilin/corpus/merge.h"
#include "rectilin/corpus/run_corpus.h"
#include "rectilin/corpus/status.h"

using namespace rectilin;
using namespace rectilin::corpus;
using namespace rectilin::test;

namespace {

CorpusSummary run(const std::filesystem::path& file, const std::vector<NamedSource>& meshes,
                  const CorpusOptions& options, const Json& settings = Json::object(), const Shard& shard = {}) {
  const Task task{"test", settings};
  Store store(file, task);
  return run_corpus(meshes, shard, store, task, options);
}

/// Meshes that are done; 0 if the store is not there yet.
std::size_t done_in(const std::filesystem::path& file) {
  try {
    return status_of(file).done;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

/// It may still be waited for.
bool has_ended(pid_t child) {
  siginfo_t state = {};
  waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT);
  return state.si_pid == child;
}

}  // namespace

TEST_CASE("every mesh becomes a row, for any number of workers", "[corpus]") {
  const ScratchFolder folder;
  std::vector<NamedSource> meshes = prisms(12);
  meshes.push_back({"missing", "missing.off", ""});
  const CorpusSummary one = run(folder.path() / "1.db", meshes, with_workers(1));
  const CorpusSummary three = run(folder.path() / "3.db", meshes, with_workers(3));
  CHECK(one.done == 12);
  CHECK(one.failed == 1);
  CHECK(three.done == 12);
  const auto rows = rows_of(folder.path() / "1.db");
  REQUIRE(rows.size() == 13);
  CHECK(rows == rows_of(folder.path() / "3.db"));
  CHECK(rows[0].name == "missing");
  CHECK(rows[0].error.starts_with("missing.off: no such file"));
  CHECK(rows[1].group == "even");
  CHECK(Json::parse(rows[1].result)["faces"] == faces_of(meshes[0]));
}

TEST_CASE("what hangs, crashes or fills the memory costs its own row", "[corpus]") {
  const ScratchFolder folder;
  const auto file = folder.path() / "store.db";
  std::vector<NamedSource> meshes = prisms(8);
  const Json settings = {{"hang", faces_of(meshes[1])},
                         {"crash", faces_of(meshes[3])},
                         {"fill", faces_of(meshes[4])},
                         {"fail", faces_of(meshes[5])},
                         {"over", faces_of(meshes[6])}};
  // The one that hangs by itself and with little time, so that a slow machine does not limit the others.
  const std::vector<NamedSource> hanging = {meshes[1]};
  meshes.erase(meshes.begin() + 1);
  CorpusOptions brief = with_workers(1), options = with_workers(2);
  brief.seconds = 0.1;
  options.seconds = 1000;
  options.memory = std::uint64_t{64} << 20;
  CHECK(run(file, hanging, brief, settings).limited == 1);
  const CorpusSummary summary = run(file, meshes, options, settings);
  CHECK(summary.done == 3);
  CHECK(summary.limited == 3);
  CHECK(summary.failed == 1);
  const auto rows = rows_of(file);
  const auto error_of = [&](std::size_t i) { return rows[i].error; };
  CHECK(error_of(1) == "more than 0.1 seconds");
  CHECK(error_of(3).find("crashed (signal 11") != std::string::npos);
  CHECK(error_of(4) == "more than 67108864 bytes of memory");
  CHECK(error_of(5) == rows[5].source + ": faces of an unlucky number");
  CHECK(rows[6].status == RowStatus::kLimited);
  CHECK_FALSE(rows[6].result.empty());  // what the search had when its time was over

  SECTION("and is tried again only when asked") {
    CHECK(run(file, meshes, options, settings).before == 7);
    options.retry = true;
    CHECK(run(file, meshes, options, settings).limited == 3);
    CHECK(rows_of(file) == rows);
  }
}

TEST_CASE("the mesh in work is to blame, and the one that waits behind it is not lost", "[corpus]") {
  const ScratchFolder folder;
  const std::vector<NamedSource> meshes = prisms(9);
  const Json settings = {{"crash", faces_of(meshes[2])}, {"fill", faces_of(meshes[3])}, {"hang", faces_of(meshes[5])}};
  CorpusOptions options = with_workers(1);
  options.seconds = 3;  // for eight that need milliseconds
  options.memory = std::uint64_t{64} << 20;
  const CorpusSummary summary = run(folder.path() / "store.db", meshes, options, settings);
  CHECK(summary.done == 6);
  CHECK(summary.limited == 3);
  const auto rows = rows_of(folder.path() / "store.db");
  for (std::size_t i = 0; i < rows.size(); ++i)
    CHECK((rows[i].status == RowStatus::kLimited) == (i == 2 || i == 3 || i == 5));
}

TEST_CASE("a mesh does not wait behind a long one while another worker has nothing to do", "[corpus]") {
  const ScratchFolder folder;
  const std::vector<NamedSource> meshes = prisms(3);  // the third is sent behind the first
  run(folder.path() / "store.db", meshes, with_workers(2), {{"slow", faces_of(meshes[0])}});
  Store store(folder.path() / "store.db");
  CHECK(store.find("prism 0")->status == RowStatus::kDone);
  CHECK(store.find("prism 2")->finished < store.find("prism 0")->finished);
}

TEST_CASE("a worker that is killed from outside is replaced, and nothing is blamed", "[corpus]") {
  const ScratchFolder folder;
  const auto file = folder.path() / "store.db";
  const std::vector<NamedSource> meshes = prisms(60);
  CorpusOptions options = with_workers(2);
  int rows = 0;
  options.on_row = [&](const Row&, const std::string&) {
    // Every tenth row, all workers of this program.
    if (++rows % 10 != 0) return;
    const std::string list = "/proc/" + std::to_string(getpid()) + "/task/" + std::to_string(getpid()) + "/children";
    std::istringstream children(text_of(list));
    for (pid_t child = 0; children >> child;) kill(child, SIGKILL);
  };
  const CorpusSummary summary = run(file, meshes, options, {{"pause", 5}});
  CHECK(summary.done + summary.limited == 60);
  CHECK(summary.limited <= 1);  // one that was killed twice looks as if it were to blame
}

TEST_CASE("results that depend on names are not shared", "[corpus]") {
  const ScratchFolder folder;
  std::vector<NamedSource> meshes;
  for (int i = 0; i < 10; ++i) meshes.push_back({"copy " + std::to_string(i), "shape:box", ""});
  CorpusOptions options = with_workers(2);
  options.share = false;
  const CorpusSummary summary = run(folder.path() / "store.db", meshes, options);
  CHECK(summary.done == 10);
  CHECK(summary.copied == 0);
  for (const Row& row : rows_of(folder.path() / "store.db")) {
    CHECK_FALSE(row.digest.empty());
    CHECK_FALSE(row.result.empty());
  }
}

TEST_CASE("equal meshes are worked on once", "[corpus]") {
  const ScratchFolder folder;
  std::vector<NamedSource> meshes;
  for (int i = 0; i < 20; ++i) meshes.push_back({"copy " + std::to_string(i), "shape:box", ""});
  const CorpusSummary summary = run(folder.path() / "store.db", meshes, with_workers(4), {{"pause", 20}});
  CHECK(summary.done == 20);
  CHECK(summary.copied == 19);
  const auto rows = rows_of(folder.path() / "store.db");
  for (const Row& row : rows) CHECK(row.result == rows[0].result);
}

TEST_CASE("shards cover a corpus once, and their number may change", "[corpus]") {
  const ScratchFolder folder;
  const std::vector<NamedSource> meshes = prisms(30);
  run(folder.path() / "whole.db", meshes, with_workers(2));
  std::vector<std::filesystem::path> stores;
  std::size_t done = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    stores.push_back(folder.path() / ("part" + std::to_string(i) + ".db"));
    done += run(stores.back(), meshes, with_workers(1), Json::object(), {i, 3}).done;
  }
  CHECK(done == 30);
  CorpusOptions options = with_workers(1);
  options.done = {stores[0], stores[1]};  // the third part is lost, and five take its place
  std::size_t again = 0;
  std::vector<std::filesystem::path> all(options.done);
  for (std::uint32_t i = 0; i < 5; ++i) {
    all.push_back(folder.path() / ("new" + std::to_string(i) + ".db"));
    again += run(all.back(), meshes, options, Json::object(), {i, 5}).done;
  }
  CHECK(again == 30 - Store(stores[0]).size() - Store(stores[1]).size());
  const MergeSummary merged = merge(all, folder.path() / "all.db");
  CHECK(merged.conflicts == 0);
  CHECK(rows_of(folder.path() / "all.db") == rows_of(folder.path() / "whole.db"));
}

TEST_CASE("a worker that cannot work ends the run", "[corpus]") {
  const ScratchFolder folder;
  CorpusOptions options;
  options.worker_command = {"/no/such/program"};
  CHECK_THROWS_WITH(run(folder.path() / "store.db", prisms(2), options), Catch::Matchers::Contains("does not start"));
}

TEST_CASE("a run killed at fifty random moments ends as one that was left alone", "[corpus]") {
  const ScratchFolder folder;
  const std::vector<NamedSource> meshes = prisms(300);
  const Json settings = {{"pause", 20}};
  run(folder.path() / "calm.db", meshes, with_workers(8), settings);
  const auto file = folder.path() / "killed.db";
  Random random(7);
  for (int kill_number = 0; kill_number < 50; ++kill_number) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      try {
        run(file, meshes, with_workers(2), settings);
      } catch (...) {
        _exit(1);
      }
      _exit(0);
    }
    // At any moment, while it starts included; or after a few meshes, so that it gets on, however slow the machine.
    if (kill_number % 2 == 1) {
      const std::size_t wanted = std::min(meshes.size(), done_in(file) + 1 + random.below(8));
      while (done_in(file) < wanted && !has_ended(child)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0, 0.05)));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE((WIFSIGNALED(status) || WEXITSTATUS(status) == 0));
  }
  const std::size_t before = done_in(file);
  CHECK(before >= 25);  // kills do not keep a run from getting on
  const CorpusSummary last = run(file, meshes, with_workers(2), settings);
  CHECK(last.before == before);
  CHECK(rows_of(file) == rows_of(folder.path() / "calm.db"));
}
