#include "archive/unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "io/text.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kCompressions = {".gz", ".xz", ".bz2", ".zst", ".lzma", ".tgz", ".txz"};
constexpr std::array<std::string_view, 3> kContainers = {".zip", ".tar", ".7z"};

std::string lower(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return low;
}

template <class Endings>
std::string_view ending_of(std::string_view file, const Endings& endings) {
  const auto found = std::ranges::find_if(endings, [&](std::string_view e) { return file.ends_with(e); });
  return found == endings.end() ? std::string_view() : *found;
}

/// The name of the only member of a compressed single file (x.obj for x.obj.gz); empty for archives of many members.
std::string only_member_of(const fs::path& file) {
  const std::string name = file.filename().string(), low = lower(name);
  const std::string_view ending = ending_of(low, kCompressions);
  if (ending.empty() || ending == ".tgz" || ending == ".txz") return {};
  const std::string inner = name.substr(0, name.size() - ending.size());
  return lower(inner).ends_with(".tar") ? std::string() : inner;
}

/// libarchive assumes that names are in the encoding of the locale. While an object of this class lives, that is UTF-8
/// for this thread.
class Utf8Locale {
 public:
  Utf8Locale() : before_(uselocale(utf8())) {}
  ~Utf8Locale() { uselocale(before_); }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;

 private:
  static locale_t utf8() {
    static const locale_t locale = newlocale(LC_CTYPE_MASK, "C.UTF-8", locale_t{});
    return locale;  // null if the system has none: the locale then stays as it is
  }
  locale_t before_;
};

}  // namespace

bool is_archive_name(std::string_view file) {
  const std::string low = lower(file);
  return !ending_of(low, kContainers).empty() || !ending_of(low, kCompressions).empty();
}

void Unpacker::Close::operator()(archive* a) const { archive_read_free(a); }

Unpacker::Unpacker(const fs::path& file) : name_(file.string()), only_member_(only_member_of(file)) {
  std::error_code error = why_unreadable(file);
  if (error) fail(system_reason(error));
  packed_ = fs::file_size(file, error);
  if (error) fail("not a regular file");
  archive_.reset(archive_read_new());
  archive* const a = archive_.get();
  for (auto* support :
       {archive_read_support_filter_gzip, archive_read_support_filter_xz, archive_read_support_filter_bzip2,
        archive_read_support_filter_lzma, archive_read_support_filter_zstd})
    support(a);
  if (only_member_.empty()) {
    for (auto* support :
         {archive_read_support_format_zip_seekable, archive_read_support_format_tar, archive_read_support_format_7zip})
      support(a);
  } else {
    archive_read_support_format_raw(a);
  }
  constexpr std::size_t kBlock = 1 << 15;
  open(archive_read_open_filename(a, file.c_str(), kBlock));
}

Unpacker::Unpacker(std::string_view zip, const std::string& name)
    : name_(name), packed_(zip.size()), archive_(archive_read_new()) {
  archive_read_support_format_zip_seekable(archive_.get());
  open(archive_read_open_memory(archive_.get(), zip.data(), zip.size()));
}

void Unpacker::open(int result) {
  if (result != ARCHIVE_OK) fail_with_library();
}

bool Unpacker::next() {
  const Utf8Locale utf8;
  archive* const a = archive_.get();
  // Skipping a member of a compressed stream unpacks it all the same, so it counts towards the limit.
  if (unread_ && archive_filter_count(a) > 1) check();
  for (;;) {
    archive_entry* entry = nullptr;
    const int result = archive_read_next_header(a, &entry);
    if (result == ARCHIVE_EOF) return false;
    if (result < ARCHIVE_WARN) fail_with_library();
    if (started_) ++position_;
    started_ = true;
    count(0);
    if (only_member_.empty() && archive_entry_filetype(entry) != AE_IFREG) continue;
    const char* path = archive_entry_pathname(entry);
    if (!path) continue;  // the name is in no known encoding
    member_ = only_member_.empty() ? path : only_member_;
    claimed_ = archive_entry_size_is_set(entry)
                   ? static_cast<std::uint64_t>(std::max<std::int64_t>(0, archive_entry_size(entry)))
                   : 0;
    unread_ = true;
    return true;
  }
}

/// Calls take(bytes, offset) for each block of the member.
template <class Take>
void Unpacker::unpack(const Take& take) {
  unread_ = false;
  std::uint64_t size = 0;
  for (;;) {
    const void* block = nullptr;
    std::size_t bytes = 0;
    std::int64_t offset = 0;
    const int result = archive_read_data_block(archive_.get(), &block, &bytes, &offset);
    if (result == ARCHIVE_EOF) return;
    if (result < ARCHIVE_WARN) fail_with_library();
    if (offset < 0 || static_cast<std::uint64_t>(offset) > kMaxMember ||
        bytes > kMaxMember - static_cast<std::uint64_t>(offset))
      fail(rectilin::quoted(member_) + " unpacks to more than " + std::to_string(kMaxMember) + " bytes");
    const std::uint64_t end = static_cast<std::uint64_t>(offset) + bytes;
    count(end - std::min(size, end));
    size = std::max(size, end);
    take(std::string_view(static_cast<const char*>(block), bytes), static_cast<std::size_t>(offset));
  }
}

std::string Unpacker::read() {
  std::string content;
  content.reserve(std::min({claimed_, kSmall, kMaxRatio * packed_}));
  unpack([&](std::string_view block, std::size_t offset) {
    content.resize(std::max(content.size(), offset));  // sparse files have holes
    content.append(block);
  });
  return content;
}

void Unpacker::check() {
  unpack([](std::string_view, std::size_t) {});
}

void Unpacker::count(std::uint64_t bytes) {
  unpacked_ += bytes;
  const auto streamed = archive_filter_bytes(archive_.get(), 0);
  const std::uint64_t most = std::max(unpacked_, static_cast<std::uint64_t>(std::max<std::int64_t>(0, streamed)));
  if (most > kSmall && most / kMaxRatio > packed_)
    fail("unpacks to more than " + std::to_string(kMaxRatio) + " times its size");
}

void Unpacker::fail(const std::string& reason) const { throw MeshError(name_ + ": " + reason); }

void Unpacker::fail_with_library() const {
  const char* text = archive_error_string(archive_.get());
  const std::string reason = text ? text : "cannot be read";
  fail("as an archive: " + rectilin::quoted(reason.substr(0, reason.find_first_of("\r\n"))));
}

}  // namespace rectilin
