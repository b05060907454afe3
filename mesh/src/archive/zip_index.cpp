#include "archive/zip_index.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "archive/unpack.h"
#include "rectilin/base/fnv1a.h"

namespace rectilin {
namespace {

// Sizes of the fixed parts of the records, and the numbers that they begin with.
constexpr std::size_t kEndSize = 22, kTableEntrySize = 46, kMemberHeaderSize = 30;
constexpr std::uint32_t kEndMark = 0x06054b50, kTableEntryMark = 0x02014b50, kHeaderMark = 0x04034b50;

constexpr std::uint32_t kElsewhere = 0xFFFFFFFF;  // the number is in a zip64 record
constexpr std::uint64_t kLargestTable = std::uint64_t{1} << 28;

/// Flags that make no difference here: levels of compression, sizes after the data (the table has them), names in
/// UTF-8. Names in other encodings, or with backslashes, are left to libarchive, which translates them.
constexpr std::uint32_t kHarmlessFlags = 0x0806 | 0x0008;

std::uint32_t zip_number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}
std::uint32_t zip_u16(std::string_view bytes, std::size_t at) { return zip_number(bytes, at, 2); }
std::uint32_t zip_u32(std::string_view bytes, std::size_t at) { return zip_number(bytes, at, 4); }

std::uint64_t zip_name_hash(std::string_view name) { return Fnv1a().add(name).value(); }

/// libarchive translates other names: from old encodings, and backslashes to slashes.
bool is_plain_name(std::string_view name) {
  return !name.empty() && name.back() != '/' &&
         std::ranges::all_of(name, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
}

/// Is the member a file, not a link or a folder, as far as Unix-like systems have recorded that?
bool is_plain_file(std::string_view table_entry) {
  constexpr std::uint32_t kUnix = 3;
  if (zip_u16(table_entry, 4) >> 8 != kUnix) return true;
  const std::uint32_t type = zip_u32(table_entry, 38) >> 16 & S_IFMT;
  return type == 0 || type == S_IFREG;
}

}  // namespace

ZipIndex::ZipIndex(const std::filesystem::path& file) : file_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat about {};
  if (file_ < 0 || fstat(file_, &about) != 0 || !S_ISREG(about.st_mode)) return;
  size_ = static_cast<std::uint64_t>(about.st_size);
  read_table(size_);
}

ZipIndex::~ZipIndex() {
  if (file_ >= 0) close(file_);
}

/// Reads bytes at a place in the file; fewer if the file ends before.
std::string ZipIndex::bytes(std::uint64_t offset, std::size_t count) const {
  std::string all(static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - std::min(size_, offset))), '\0');
  std::size_t have = 0;
  while (have < all.size()) {
    const ssize_t got = pread(file_, all.data() + have, all.size() - have, static_cast<off_t>(offset + have));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
  }
  all.resize(have);
  return all;
}

void ZipIndex::read_table(std::uint64_t file_size) {
  // The record at the end is followed by a comment, of which it states the length.
  constexpr std::uint64_t kLongestComment = 0xFFFF;
  const std::uint64_t begin = file_size - std::min(file_size, kEndSize + kLongestComment);
  const std::string tail = bytes(begin, kEndSize + kLongestComment);
  if (tail.size() < kEndSize) return;
  std::size_t end = tail.size() - kEndSize;
  while (zip_u32(tail, end) != kEndMark || end + kEndSize + zip_u16(tail, end + 20) != tail.size())
    if (end-- == 0) return;
  const std::uint32_t count = zip_u16(tail, end + 10), table_size = zip_u32(tail, end + 12),
                      offset = zip_u32(tail, end + 16);
  // Archives of more than 65,534 members have a further record, which repeats what still fits in this one.
  constexpr std::uint32_t kMany = 0xFFFF;
  if (zip_u16(tail, end + 4) != 0 || offset == kElsewhere || table_size > kLargestTable ||
      std::uint64_t{offset} + table_size > begin + end)
    return;

  const std::string table = bytes(offset, table_size);
  std::uint64_t unpacked = 0;
  std::size_t found = 0, at = 0;
  for (; at + kTableEntrySize <= table.size(); ++found) {
    const std::string_view entry = std::string_view(table).substr(at);
    const std::size_t name_size = zip_u16(entry, 28);
    at += kTableEntrySize + name_size + zip_u16(entry, 30) + zip_u16(entry, 32);
    if (zip_u32(entry, 0) != kTableEntryMark || at > table.size()) return entries_.clear();
    const std::string_view name = entry.substr(kTableEntrySize, name_size);
    const std::uint32_t method = zip_u16(entry, 10);
    const Entry e{zip_name_hash(name),
                  zip_u32(entry, 42),
                  zip_u32(entry, 20),
                  zip_u32(entry, 24),
                  zip_u32(entry, 16),
                  method == 8,
                  false};
    unpacked += e.unpacked;
    const bool sizes = e.offset != kElsewhere && e.packed != kElsewhere && e.unpacked <= Unpacker::kMaxMember &&
                       (e.deflated || e.packed == e.unpacked);
    const bool plain = (zip_u16(entry, 8) & ~kHarmlessFlags) == 0 && (method == 0 || method == 8) &&
                       is_plain_name(name) && is_plain_file(entry) && zip_u16(entry, 34) == 0;
    entries_.push_back(e);
    entries_.back().usable = sizes && plain;
  }
  if (at != table.size() || (found != count && count != kMany) ||
      (unpacked > Unpacker::kSmall && unpacked / Unpacker::kMaxRatio > file_size))
    return entries_.clear();
  std::ranges::sort(entries_, {}, &Entry::hash);
  for (std::size_t i = 1; i < entries_.size(); ++i)
    if (entries_[i].hash == entries_[i - 1].hash) entries_[i].usable = entries_[i - 1].usable = false;
}

std::size_t ZipIndex::size() const {
  return static_cast<std::size_t>(std::ranges::count(entries_, true, &Entry::usable));
}

std::optional<std::string> ZipIndex::read(std::string_view member) const {
  const auto entry = std::ranges::lower_bound(entries_, zip_name_hash(member), {}, &Entry::hash);
  if (entry == entries_.end() || entry->hash != zip_name_hash(member) || !entry->usable) return std::nullopt;

  // The member's own header has fields that the table does not give the length of; there is nearly always room for them
  // in this, so that header and data are read at once.
  constexpr std::size_t kRoom = 64;
  std::string packed = bytes(entry->offset, kMemberHeaderSize + member.size() + kRoom + entry->packed);
  if (packed.size() < kMemberHeaderSize + member.size() || zip_u32(packed, 0) != kHeaderMark ||
      (zip_u16(packed, 6) & ~kHarmlessFlags) != 0 || zip_u16(packed, 8) != (entry->deflated ? 8u : 0u) ||
      zip_u16(packed, 26) != member.size() ||
      std::string_view(packed).substr(kMemberHeaderSize, member.size()) != member)
    return std::nullopt;
  const std::size_t start = kMemberHeaderSize + member.size() + zip_u16(packed, 28), end = start + entry->packed;
  if (packed.size() < end) packed = bytes(entry->offset, end);
  if (packed.size() < end) return std::nullopt;

  std::string content;
  if (entry->deflated) {
    content.resize(entry->unpacked);
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflate(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!inflate) throw std::bad_alloc();
    if (libdeflate_deflate_decompress(inflate.get(), packed.data() + start, entry->packed, content.data(),
                                      content.size(), nullptr) != LIBDEFLATE_SUCCESS)
      return std::nullopt;
  } else {
    content.assign(packed, start, entry->packed);
  }
  if (libdeflate_crc32(0, content.data(), content.size()) != entry->checksum) return std::nullopt;
  return content;
}

}  // namespace rectilin
