#include "rectilin/base/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <stdexcept>

#include "rectilin/base/system_reason.h"
#include "rectilin/base/unfinished_files.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void throw_errno() { throw std::system_error(errno, std::generic_category()); }

void write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) throw_errno();
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// The file that is to be replaced, found by following any links; nothing if the file is new.
struct Replaced {
  fs::path path;
  struct stat status;
};

/// Names in these folders stand for devices or for files that a process has open: they are written to, never replaced.
bool is_of_system(const fs::path& file) {
  const std::string path = fs::absolute(file).string();
  return path.starts_with("/dev/") || path.starts_with("/proc/");
}

void write_in_place(const fs::path& file, std::string_view content) {
  const int flags = is_of_system(file) ? O_APPEND : O_TRUNC;
  const Descriptor out(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666));
  if (out.get() < 0) throw_errno();
  write_all(out.get(), content);
}

void write_beside(const fs::path& file, const std::optional<Replaced>& replaced, std::string_view content, bool named) {
  const fs::path& target = replaced ? replaced->path : file;
  UnfinishedFile begun(target.has_parent_path() ? target.parent_path() : fs::path("."), named);
  write_all(begun.descriptor(), content);
  if (replaced) {
    // Only root may give a file to another owner. Where that fails the user owns the new file; its permissions, which
    // matter, are kept all the same.
    if (fchown(begun.descriptor(), replaced->status.st_uid, replaced->status.st_gid) != 0) errno = 0;
    if (fchmod(begun.descriptor(), replaced->status.st_mode & 0777) != 0) throw_errno();
  }
  if (begun.take_name()) return begun.become(target);
  if (!named) write_beside(file, replaced, content, true);
}

void write(const fs::path& file, std::string_view content) {
  struct stat status {};
  std::optional<Replaced> replaced;
  if (stat(file.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode) || is_of_system(file)) return write_in_place(file, content);
    replaced = Replaced{fs::canonical(file), status};
    if (access(file.c_str(), W_OK) != 0) throw_errno();
  } else if (errno != ENOENT) {
    throw_errno();
  } else if (lstat(file.c_str(), &status) == 0) {
    return write_in_place(file, content);  // a link that leads nowhere
  }
  write_beside(file, replaced, content, false);
}

std::string read(const fs::path& file) {
  const Descriptor in(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.get() < 0) throw_errno();
  struct stat status {};
  if (fstat(in.get(), &status) != 0) throw_errno();
  if (S_ISDIR(status.st_mode)) throw std::system_error(EISDIR, std::generic_category());
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) throw std::runtime_error("is a device, not a file or a pipe");
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  std::string bytes;
  std::size_t filled = 0;
  while (true) {
    // Asking for one byte more than the size shows the end of the file in the same read.
    const std::size_t expected = static_cast<std::size_t>(status.st_size) + 1;
    bytes.resize(filled < expected ? expected : filled + std::max(kPiece, filled / 2));
    const ssize_t got = ::read(in.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_errno();
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

std::string read_whole_file(const fs::path& file) try { return read(file); } catch (const std::system_error& e) {
  throw std::runtime_error(file.string() + ": " + system_reason(e.code()));
} catch (const std::runtime_error& e) {
  throw std::runtime_error(file.string() + ": " + e.what());
}

void write_whole_file(const fs::path& file, std::string_view content) try {
  write(file, content);
} catch (const std::system_error& e) {
  throw std::runtime_error(file.string() + ": cannot be written: " + system_reason(e.code()));
}

}  // namespace rectilin
