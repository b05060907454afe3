// How far a run is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace rectilin::corpus {

struct StoreStatus {
  std::string shard;     ///< of the last run, "I/N"; empty if there was none, as in a merged store
  bool running = false;  ///< a program is writing to it, on this machine
  std::size_t done = 0, failed = 0, limited = 0, left = 0;
  double rate = 0;                     ///< meshes a second, in the last run
  std::optional<double> seconds_left;  ///< at this rate; none if there is no rate to go by
};

/// Throws std::runtime_error as Store does. The store may be in use.
StoreStatus status_of(const std::filesystem::path& store);

}  // namespace rectilin::corpus
