#include "rectilin/corpus/merge.h"

#include <optional>

#include "store_access.h"

namespace rectilin::corpus {
namespace {

constexpr const char* kBothDone =
    " FROM part.meshes AS theirs JOIN main.meshes AS ours ON ours.name = theirs.name"
    " WHERE theirs.status = 3 AND ours.status = 3 AND (theirs.digest <> ours.digest OR theirs.result <> ours.result)";

constexpr const char* kAdd =
    "INSERT INTO main.meshes SELECT * FROM part.meshes WHERE true ON CONFLICT(name) DO UPDATE SET"
    " source = excluded.source, class = excluded.class, status = excluded.status, digest = excluded.digest,"
    " faces = excluded.faces, area = excluded.area, rectilinearity = excluded.rectilinearity, lower = excluded.lower,"
    " upper = excluded.upper, result = excluded.result, report = excluded.report, error = excluded.error,"
    " version = excluded.version, finished = excluded.finished, seconds = excluded.seconds"
    " WHERE excluded.status > meshes.status";

void find_conflicts(Database& database, const std::string& store, MergeSummary& summary) {
  constexpr std::size_t kShown = 10;
  Statement conflicts(
      database, std::string("SELECT ours.name, theirs.digest <> ours.digest") + kBothDone + " ORDER BY ours.name");
  for (std::size_t found = 0; conflicts.step(); ++found, ++summary.conflicts) {
    if (found < kShown)
      summary.first.push_back(
          {std::string(conflicts.text(0)), store,
           conflicts.integer(1) ? "another mesh has this name" : "another result for the same mesh"});
  }
}

}  // namespace

MergeSummary merge(std::span<const std::filesystem::path> stores, const std::filesystem::path& target) {
  std::optional<Task> task;
  for (const auto& file : stores) {
    const Task found = Store(file).task();
    if (!task) task = found;
    else if (found.name != task->name || found.settings != task->settings)
      throw ParameterError(file.string() + ": holds results of another task or other settings than " +
                           stores.front().string());
    std::error_code ignored;
    if (std::filesystem::equivalent(file, target, ignored))
      throw ParameterError(target.string() + ": a store cannot be merged into itself");
  }
  if (!task) throw ParameterError("no stores to merge");

  Store all(target, *task);
  Database& database = StoreAccess::database(all);
  MergeSummary summary;
  // This is one large change: with this kind of journal SQLite writes most of it only once.
  database.execute("PRAGMA journal_mode = TRUNCATE; PRAGMA cache_size = -262144; PRAGMA temp_store = MEMORY");
  for (const auto& file : stores) {
    const std::string name = file.string();
    Statement(database, "ATTACH ?1 AS part").bind(1, std::string_view(name)).run();
    {
      Transaction transaction(database);
      find_conflicts(database, name, summary);
      Statement changes(database, "SELECT total_changes()");
      const auto count = [&] {
        changes.step();
        const std::int64_t n = changes.integer(0);
        changes.reset();
        return n;
      };
      const std::int64_t before = count();
      Statement(database, kAdd).run();
      summary.added += static_cast<std::size_t>(count() - before);
      transaction.commit();
    }
    database.execute("DETACH part");
  }
  summary.rows = all.size();
  return summary;
}

}  // namespace rectilin::corpus
