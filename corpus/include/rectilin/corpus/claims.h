// Which job does which mesh, in memory that all workers share, so that a worker need not ask whether a mesh is new.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace rectilin::corpus {

/// A table of the digests of meshes, each with the job that does it. The first to claim a digest has it, whichever
/// process it is in. Safe for threads and processes; a process may be killed at any moment. Throws std::runtime_error
/// if the system has no memory for it.
class Claims {
 public:
  /// The owner of meshes that were done before.
  static constexpr std::uint64_t kDone = ~std::uint64_t{1};

  /// An empty table with room for so many digests, and a file descriptor by which other processes may open it.
  static Claims make(std::size_t digests);
  /// The table of another process, of which this one has inherited a file descriptor.
  static Claims open(int file);
  ~Claims();
  Claims(Claims&& other) noexcept;

  int file() const { return file_; }

  /// Claims a digest (mesh_digest()) for a job; true if the digest is now that job's, or was before.
  bool claim(std::string_view digest, std::uint64_t job);
  /// The job whose mesh it is; kDone for a mesh done before or not claimed.
  std::uint64_t owner(std::string_view digest) const;
  /// Gives a digest that is claimed to another job.
  void give(std::string_view digest, std::uint64_t job);

 private:
  struct Entry {
    std::atomic<std::uint64_t> digest, owner;  ///< 0: free
  };
  explicit Claims(int file);
  /// The entry of a digest; a new one if there is none.
  Entry& entry(std::string_view digest) const;

  int file_ = -1;
  std::size_t size_ = 0;  ///< entries; a power of two
  Entry* entries_ = nullptr;
};

}  // namespace rectilin::corpus
