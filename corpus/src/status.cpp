#include "rectilin/corpus/status.h"

#include <algorithm>
#include <chrono>

#include "rectilin/corpus/writer_lock.h"
#include "store_access.h"

namespace rectilin::corpus {

StoreStatus status_of(const std::filesystem::path& file) {
  Store store(file);
  Database& database = StoreAccess::database(store);
  StoreStatus status;
  status.running = is_being_written(file);
  Statement counts(database, "SELECT status, count(*) FROM meshes GROUP BY status");
  while (counts.step()) {
    const auto count = static_cast<std::size_t>(counts.integer(1));
    switch (static_cast<RowStatus>(counts.integer(0))) {
      case RowStatus::kLeft:
        status.left = count;
        break;
      case RowStatus::kDone:
        status.done = count;
        break;
      case RowStatus::kFailed:
        status.failed = count;
        break;
      case RowStatus::kLimited:
        status.limited = count;
        break;
    }
  }
  Statement run(database, "SELECT shard, started FROM runs ORDER BY id DESC LIMIT 1");
  if (!run.step()) return status;
  status.shard = run.text(0);
  const double started = run.real(1);
  run.reset();
  Statement finished(database, "SELECT count(*), max(finished) FROM meshes WHERE status > 0 AND finished >= ?1");
  if (finished.bind(1, started).step() && finished.integer(0) > 0)
    set_rate(status, static_cast<std::size_t>(finished.integer(0)), started, finished.real(1));
  return status;
}

void set_rate(StoreStatus& status, std::size_t finished, double started, double last) {
  const double now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double elapsed = (status.running ? now : last) - started;
  status.rate = static_cast<double>(finished) / std::max(elapsed, 1e-3);
  status.seconds_left = static_cast<double>(status.left) / status.rate;
}

}  // namespace rectilin::corpus
