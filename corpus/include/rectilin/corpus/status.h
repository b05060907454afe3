// Progress of a run, read from its store.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace rectilin::corpus {

struct StoreStatus {
  std::string shard;     ///< shard of the last run, "I/N"; empty if none was recorded, as in a merged store
  bool running = false;  ///< whether a program on this machine is writing to the store
  std::size_t done = 0, failed = 0, limited = 0, left = 0;
  double rate = 0;                     ///< meshes a second, in the last run
  std::optional<double> seconds_left;  ///< estimated from this rate; none if no rate is known
};

/// Throws std::runtime_error as Store does. The store may be in use.
StoreStatus status_of(const std::filesystem::path& store);

/// Sets rate and time left of a run that began at `started` and has finished so many meshes, the last of them at `last`
/// (seconds since 1970). The rate is counted up to now if the run goes on, otherwise up to its last mesh.
void set_rate(StoreStatus& status, std::size_t finished, double started, double last);

}  // namespace rectilin::corpus
