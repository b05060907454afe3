// Members of ordinary zip archives, read from where the archive's table says that they are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rectilin {

/// The table at the end of a zip archive (PKWARE, APPNOTE.TXT 6.3.10, section 4.3). libarchive inflates with zlib,
/// through a window, and looks at each member's header on the way; with the table a member is one read and one call of
/// libdeflate, which needs less than half of zlib's time.
///
/// Only what is ordinary is in this index: members that are stored or deflated, not encrypted, smaller than 4 GiB,
/// with a name in ASCII that no other member has. All the rest is left to class Unpacker, which also finds the words
/// for what is wrong. The limits are those of Unpacker. Thread safe once constructed.
class ZipIndex {
 public:
  /// Reads the table. The index is empty if the file is no ordinary zip archive, or if all its members together
  /// unpack to more than an archive may.
  explicit ZipIndex(const std::filesystem::path& file);
  ~ZipIndex();
  ZipIndex(const ZipIndex&) = delete;
  ZipIndex& operator=(const ZipIndex&) = delete;

  /// Members that read() can give.
  std::size_t size() const;

  /// The content of a member; nothing if it is not in the index, or if anything is not as the table says, the checksum
  /// included.
  std::optional<std::string> read(std::string_view member) const;

 private:
  struct Entry {
    std::uint64_t hash;  ///< of the name
    std::uint32_t offset, packed, unpacked, checksum;
    bool deflated, usable;  ///< usable: ordinary, and no other name has the same hash
  };

  void read_table(std::uint64_t file_size);
  std::string bytes(std::uint64_t offset, std::size_t count) const;

  int file_;  ///< descriptor; negative if the file could not be opened
  std::uint64_t size_ = 0;
  std::vector<Entry> entries_;  ///< sorted by hash
};

}  // namespace rectilin
