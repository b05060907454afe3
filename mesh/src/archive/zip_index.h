// Reads members of ordinary zip archives at the places that the archive's table states.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rectilin {

/// The table at the end of a zip archive (PKWARE, APPNOTE.TXT 6.3.10, section 4.3). libarchive reads the header of each
/// member on the way and inflates with zlib through a window. With the table a member takes one read and one call of
/// libdeflate, which needs less than half of zlib's time.
///
/// The index only has ordinary members: stored or deflated, not encrypted, smaller than 4 GiB, and with a unique ASCII
/// name. Everything else is left to class Unpacker, which also says what is wrong with a file. The limits are those of
/// Unpacker. Thread safe once constructed.
class ZipIndex {
 public:
  /// Reads the table. The index is empty if the file is not an ordinary zip archive, or if all its members together
  /// unpack to more than an archive may.
  explicit ZipIndex(const std::filesystem::path& file);
  ~ZipIndex();
  ZipIndex(const ZipIndex&) = delete;
  ZipIndex& operator=(const ZipIndex&) = delete;

  /// Members that read() can give.
  std::size_t size() const;

  /// The content of a member; nothing if it is not in the index, or if anything, such as the checksum, differs from
  /// what the table says.
  std::optional<std::string> read(std::string_view member) const;

 private:
  struct Entry {
    std::uint64_t hash;  ///< hash of the name
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
