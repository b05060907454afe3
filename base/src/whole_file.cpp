#include "rectilin/base/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
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

int open_in_place(const fs::path& file) {
  const int flags = is_of_system(file) ? O_APPEND : O_TRUNC;
  return open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
}

/// How a file is to be written: in place, or to a file beside it, which replaces what is there, if anything is.
struct Way {
  bool in_place = false;
  std::optional<Replaced> replaced;
};

Way way_to(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode) || is_of_system(file)) return {true, {}};
    if (access(file.c_str(), W_OK) != 0) throw_errno();
    return {false, Replaced{fs::canonical(file), status}};
  }
  if (errno != ENOENT) throw_errno();
  return {lstat(file.c_str(), &status) == 0, {}};  // in place if it is a link that leads nowhere
}

/// The file that is written beside another one, or beside its own future name.
class Beside {
 public:
  Beside(const fs::path& file, const std::optional<Replaced>& replaced, bool named)
      : target_(replaced ? replaced->path : file),
        replaced_(replaced),
        begun_(target_.has_parent_path() ? target_.parent_path() : fs::path("."), named) {}

  void write(std::string_view content) { write_all(begun_.descriptor(), content); }

  /// Gives the file its name; returns false if the system cannot give an unnamed file a name.
  bool finish() {
    if (replaced_) {
      // Only root may give a file to another owner. Where that fails the user owns the new file; its permissions, which
      // matter, are kept all the same.
      if (fchown(begun_.descriptor(), replaced_->status.st_uid, replaced_->status.st_gid) != 0) errno = 0;
      if (fchmod(begun_.descriptor(), replaced_->status.st_mode & 0777) != 0) throw_errno();
    }
    if (!begun_.take_name()) return false;
    begun_.become(target_);
    return true;
  }

 private:
  fs::path target_;
  std::optional<Replaced> replaced_;
  UnfinishedFile begun_;
};

bool write_beside(const fs::path& file, const std::optional<Replaced>& replaced, std::string_view content, bool named) {
  Beside beside(file, replaced, named);
  beside.write(content);
  return beside.finish();
}

void write(const fs::path& file, std::string_view content) {
  const Way way = way_to(file);
  if (way.in_place) {
    const Descriptor out(open_in_place(file));
    if (out.get() < 0) throw_errno();
    return write_all(out.get(), content);
  }
  if (!write_beside(file, way.replaced, content, false)) write_beside(file, way.replaced, content, true);
}

/// Runs a step of writing a file; its errors name the file and the system's reason.
template <class Step>
void writing(const fs::path& file, const Step& step) try {
  step();
} catch (const std::system_error& e) {
  throw std::runtime_error(file.string() + ": cannot be written: " + system_reason(e.code()));
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

std::error_code why_unreadable(const fs::path& file) {
  const auto reason = [](int number) { return std::error_code(number, std::generic_category()); };
  const Descriptor in(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (in.get() < 0) return reason(errno);
  struct stat status {};
  if (fstat(in.get(), &status) != 0) return reason(errno);
  return S_ISDIR(status.st_mode) ? reason(EISDIR) : std::error_code();
}

std::string read_whole_file(const fs::path& file) try { return read(file); } catch (const std::system_error& e) {
  throw std::runtime_error(file.string() + ": " + system_reason(e.code()));
} catch (const std::runtime_error& e) {
  throw std::runtime_error(file.string() + ": " + e.what());
}

void write_whole_file(const fs::path& file, std::string_view content) {
  writing(file, [&] { rectilin::write(file, content); });
}

GrowingFile::GrowingFile(const fs::path& file) : file_(file) {
  writing(file_, [&] {
    const Way way = way_to(file_);
    if (way.in_place) {
      const auto out = std::make_shared<Descriptor>(open_in_place(file_));
      if (out->get() < 0) throw_errno();
      write_ = [out](std::string_view piece) { write_all(out->get(), piece); };
      finish_ = [] {};
    } else {
      const auto beside = std::make_shared<Beside>(file_, way.replaced, true);
      write_ = [beside](std::string_view piece) { beside->write(piece); };
      finish_ = [beside] { beside->finish(); };
    }
  });
}

void GrowingFile::write(std::string_view piece) {
  writing(file_, [&] { write_(piece); });
}

void GrowingFile::finish() { writing(file_, finish_); }

}  // namespace rectilin
