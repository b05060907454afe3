#include "rectilin/corpus/merge.h"

#include "store_access.h"

namespace rectilin::corpus {
namespace {

const MergeSql kMergeStores = {
    "SELECT ours.name, theirs.digest <> ours.digest FROM part.meshes AS theirs JOIN main.meshes AS ours"
    " ON ours.name = theirs.name WHERE theirs.status = 3 AND ours.status = 3"
    " AND (theirs.digest <> ours.digest OR theirs.result <> ours.result) ORDER BY ours.name",
    {"INSERT INTO main.meshes SELECT * FROM part.meshes WHERE true ON CONFLICT(name) DO UPDATE SET"
     " source = excluded.source, class = excluded.class, status = excluded.status, digest = excluded.digest,"
     " faces = excluded.faces, area = excluded.area, rectilinearity = excluded.rectilinearity, lower = excluded.lower,"
     " upper = excluded.upper, result = excluded.result, report = excluded.report, error = excluded.error,"
     " version = excluded.version, finished = excluded.finished, seconds = excluded.seconds"
     " WHERE excluded.status > meshes.status"},
    0};

void find_conflicts(Database& database, const std::string& file, const MergeSql& sql, MergeSummary& summary) {
  constexpr std::size_t kShown = 10;
  Statement conflicts(database, sql.conflicts);
  for (std::size_t found = 0; conflicts.step(); ++found, ++summary.conflicts) {
    if (found < kShown)
      summary.first.push_back(
          {std::string(conflicts.text(0)), file,
           conflicts.integer(1) ? "another mesh has this name" : "another result for the same mesh"});
  }
}

std::int64_t total_changes(Database& database) {
  Statement changes(database, "SELECT total_changes()");
  changes.step();
  return changes.integer(0);
}

}  // namespace

void check_merge(std::span<const std::filesystem::path> files, const std::filesystem::path& target) {
  if (files.empty()) throw ParameterError("no stores to merge");
  for (const auto& file : files) {
    std::error_code ignored;
    if (std::filesystem::equivalent(file, target, ignored))
      throw ParameterError(target.string() + ": a store cannot be merged into itself");
  }
}

void merge_file(Database& target, const std::filesystem::path& file, const MergeSql& sql, MergeSummary& summary) {
  // This is one large change: with this kind of journal SQLite writes most of it only once.
  target.execute("PRAGMA journal_mode = TRUNCATE; PRAGMA cache_size = -262144; PRAGMA temp_store = MEMORY");
  const std::string name = file.string();
  Statement(target, "ATTACH ?1 AS part").bind(1, std::string_view(name)).run();
  {
    Transaction transaction(target);
    find_conflicts(target, name, sql, summary);
    for (std::size_t i = 0; i < sql.take.size(); ++i) {
      const std::int64_t before = total_changes(target);
      Statement(target, sql.take[i]).run();
      if (i == sql.counted) summary.added += static_cast<std::size_t>(total_changes(target) - before);
    }
    transaction.commit();
  }
  target.execute("DETACH part");
}

MergeSummary merge(std::span<const std::filesystem::path> stores, const std::filesystem::path& target) {
  check_merge(stores, target);
  const Task task = Store(stores.front()).task();
  for (const auto& file : stores)
    if (const Task found = Store(file).task(); found != task)
      throw ParameterError(file.string() + ": holds results of another task or other settings than " +
                           stores.front().string() + ": " + difference(found, task));
  Store all(target, task);
  MergeSummary summary;
  for (const auto& file : stores) merge_file(StoreAccess::database(all), file, kMergeStores, summary);
  summary.rows = all.size();
  return summary;
}

}  // namespace rectilin::corpus
