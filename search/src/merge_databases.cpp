#include "rectilin/search/merge_databases.h"

#include "database_access.h"

namespace rectilin::search {
namespace {

const corpus::MergeSql kMergeSignatures = {
    "SELECT ours.name, theirs.digest <> ours.digest FROM part.members AS theirs JOIN main.members AS ours"
    " ON ours.name = theirs.name WHERE theirs.status = 2 AND ours.status = 2 AND (theirs.digest <> ours.digest"
    " OR EXISTS (SELECT 1 FROM part.signatures AS p JOIN main.signatures AS q ON q.part = p.part"
    "            WHERE p.member = theirs.id AND q.member = ours.id AND p.bytes <> q.bytes)) ORDER BY ours.name",
    {"CREATE TEMP TABLE taken AS SELECT theirs.id AS theirs, theirs.name AS name FROM part.members AS theirs"
     " LEFT JOIN main.members AS ours ON ours.name = theirs.name WHERE ours.id IS NULL OR theirs.status > ours.status",
     "INSERT INTO main.members(name, source, digest, status, faces, rectilinearity, size, error, seconds)"
     " SELECT m.name, source, digest, status, faces, rectilinearity, size, error, seconds FROM part.members AS m"
     " JOIN temp.taken ON theirs = m.id WHERE true ORDER BY m.name ON CONFLICT(name) DO UPDATE SET"
     " source = excluded.source, digest = excluded.digest, status = excluded.status, faces = excluded.faces,"
     " rectilinearity = excluded.rectilinearity, size = excluded.size, error = excluded.error,"
     " seconds = excluded.seconds",
     "INSERT OR REPLACE INTO main.signatures(member, part, bytes) SELECT ours.id, part, bytes FROM part.signatures AS s"
     " JOIN temp.taken ON theirs = s.member JOIN main.members AS ours ON ours.name = taken.name",
     "DROP TABLE temp.taken"},
    1};

}  // namespace

corpus::MergeSummary merge_databases(std::span<const std::filesystem::path> files,
                                     const std::filesystem::path& target) {
  corpus::check_merge(files, target);
  const std::string descriptor = Database(files.front()).descriptor();
  for (const auto& file : files)
    if (const std::string found = Database(file).descriptor(); found != descriptor)
      throw ParameterError(file.string() + ": holds signatures of '" + found + "', not of '" + descriptor + "' as " +
                           files.front().string());
  Database all(target, descriptor);
  corpus::MergeSummary summary;
  for (const auto& file : files) corpus::merge_file(DatabaseAccess::file(all), file, kMergeSignatures, summary);
  summary.rows = all.members().size();
  return summary;
}

}  // namespace rectilin::search
