#include "rectilin/base/unfinished_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <system_error>

namespace rectilin {
namespace {

/// The names of unfinished files, in fixed places. A signal handler reads them, so it must find them without a lock and
/// without a pointer that another thread may be freeing.
struct Slot {
  enum State { kFree, kBusy, kInUse };
  std::atomic<int> state = kFree;
  char name[4096];
};
std::array<Slot, 64> slots;
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::size_t kNoSlot = slots.size();  // there are more files than slots: a signal leaves this one behind

std::size_t remember(const std::string& name) {
  if (name.size() >= sizeof Slot::name) return kNoSlot;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int free = Slot::kFree;
    if (!slots[i].state.compare_exchange_strong(free, Slot::kBusy)) continue;
    std::memcpy(slots[i].name, name.c_str(), name.size() + 1);
    slots[i].state = Slot::kInUse;
    return i;
  }
  return kNoSlot;
}

std::string random_name() {
  static std::atomic<std::uint64_t> count = 0;
  std::random_device device;
  const std::uint64_t bits = (static_cast<std::uint64_t>(device()) << 32 | device()) + count++;
  char text[40];
  std::snprintf(text, sizeof text, ".rectilin-%016llx", static_cast<unsigned long long>(bits));
  return text;
}

[[noreturn]] void throw_error() { throw std::system_error(errno, std::generic_category()); }

constexpr mode_t kMode = 0666;  // the umask applies, as for any new file

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& folder, bool named) : folder_(folder), slot_(kNoSlot) {
#ifdef O_TMPFILE
  if (!named) descriptor_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  if (descriptor_ >= 0) return;
#endif
  for (int attempt = 0; attempt < 100; ++attempt) {
    choose_name();
    descriptor_ = open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kMode);
    if (descriptor_ >= 0) return;
    const int error = errno;
    forget_name();
    errno = error;
    if (error != EEXIST) throw_error();
  }
  throw_error();
}

UnfinishedFile::~UnfinishedFile() {
  if (named()) unlink(name_.c_str());
  forget_name();
  if (descriptor_ >= 0) close(descriptor_);
}

/// Chooses a name that is free. It is noted before the file is made, so that a signal in between cannot leave the
/// file behind.
void UnfinishedFile::choose_name() {
  struct stat status {};
  do name_ = folder_ / random_name();
  while (lstat(name_.c_str(), &status) == 0);
  slot_ = remember(name_);
}

void UnfinishedFile::forget_name() {
  if (slot_ != kNoSlot) slots[slot_].state = Slot::kFree;
  slot_ = kNoSlot;
  name_.clear();
}

bool UnfinishedFile::take_name() {
  if (named()) return true;
  const std::string open_file = "/proc/self/fd/" + std::to_string(descriptor_);
  choose_name();
  if (linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  forget_name();
  return false;
}

void UnfinishedFile::become(const std::filesystem::path& file) {
  if (rename(name_.c_str(), file.c_str()) != 0) throw_error();
  forget_name();
}

void remove_unfinished_files() noexcept {
  for (const Slot& slot : slots)
    if (slot.state == Slot::kInUse) unlink(slot.name);
}

}  // namespace rectilin
