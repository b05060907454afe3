#include "rectilin/search/status.h"

#include <charconv>

#include "database_access.h"
#include "rectilin/corpus/writer_lock.h"

namespace rectilin::search {
namespace {

double number_of(const std::string& fact) {
  double x = 0;
  std::from_chars(fact.data(), fact.data() + fact.size(), x);
  return x;
}

}  // namespace

corpus::StoreStatus status_of(const std::filesystem::path& path) {
  Database database(path);
  corpus::Database& file = DatabaseAccess::file(database);
  corpus::StoreStatus status;
  status.running = corpus::is_being_written(path);
  status.shard = corpus::fact(file, "shard");
  corpus::Statement counts(file, "SELECT status, count(*) FROM members GROUP BY status");
  while (counts.step()) {
    const auto count = static_cast<std::size_t>(counts.integer(1));
    const auto kind = static_cast<MemberStatus>(counts.integer(0));
    (kind == MemberStatus::kLeft ? status.left : kind == MemberStatus::kDone ? status.done : status.failed) += count;
  }
  const std::string started = corpus::fact(file, "started");
  const auto before = static_cast<std::size_t>(number_of(corpus::fact(file, "finished_before")));
  const std::size_t finished = status.done + status.failed;
  if (status.running && !started.empty() && finished > before)
    corpus::set_rate(status, finished - before, number_of(started), 0);
  return status;
}

}  // namespace rectilin::search
