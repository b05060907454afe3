#include "rectilin/corpus/claims.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <string>
#include <utility>

#include "rectilin/base/system_reason.h"

namespace rectilin::corpus {
namespace {

[[noreturn]] void no_shared_memory() {
  throw std::runtime_error("no memory to share with the workers: " + system_reason(errno));
}

/// The number in a digest such as fnv1a64:0123456789abcdef; never 0.
std::uint64_t number_of(std::string_view digest) {
  digest.remove_prefix(digest.rfind(':') + 1);
  std::uint64_t number = 0;
  std::from_chars(digest.data(), digest.data() + digest.size(), number, 16);
  return number == 0 ? 1 : number;
}

/// Owners are kept as one more, since 0 is a free entry.
std::uint64_t kept(std::uint64_t job) { return job + 1; }

}  // namespace

Claims Claims::make(std::size_t digests) {
  const int file = memfd_create("rectilin", MFD_CLOEXEC);
  if (file < 0) no_shared_memory();
  const std::size_t entries = std::bit_ceil(2 * digests + 16);  // at most half full: few steps to a free one
  if (ftruncate(file, static_cast<off_t>(entries * sizeof(Entry))) != 0) {
    close(file);
    no_shared_memory();
  }
  return Claims(file);
}

Claims Claims::open(int file) { return Claims(file); }

Claims::Claims(int file) : file_(file) {
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "a lock would be of one process only");
  struct stat about {};
  void* memory = MAP_FAILED;
  if (fstat(file, &about) == 0)
    memory = mmap(nullptr, static_cast<std::size_t>(about.st_size), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) {
    close(file);
    no_shared_memory();
  }
  size_ = static_cast<std::size_t>(about.st_size) / sizeof(Entry);
  entries_ = static_cast<Entry*>(memory);  // zeros, which is what atomic numbers of this size begin as
}

Claims::Claims(Claims&& other) noexcept
    : file_(std::exchange(other.file_, -1)), size_(other.size_), entries_(std::exchange(other.entries_, nullptr)) {}

Claims::~Claims() {
  if (entries_) munmap(entries_, size_ * sizeof(Entry));
  if (file_ >= 0) close(file_);
}

Claims::Entry& Claims::entry(std::string_view digest) const {
  const std::uint64_t number = number_of(digest);
  for (std::size_t i = number;; ++i) {
    Entry& e = entries_[i & (size_ - 1)];
    std::uint64_t found = 0;
    if (e.digest.compare_exchange_strong(found, number) || found == number) return e;
  }
}

bool Claims::claim(std::string_view digest, std::uint64_t job) {
  std::uint64_t found = 0;
  return entry(digest).owner.compare_exchange_strong(found, kept(job)) || found == kept(job);
}

std::uint64_t Claims::owner(std::string_view digest) const {
  const std::uint64_t found = entry(digest).owner;
  return found == 0 ? kDone : found - 1;
}

void Claims::give(std::string_view digest, std::uint64_t job) { entry(digest).owner = kept(job); }

}  // namespace rectilin::corpus
