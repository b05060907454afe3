// Reads archives and compressed files with libarchive, and limits how much they may unpack to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct archive;

namespace rectilin {

/// Goes through the members of an archive once, in the order in which they are stored. Reads only what needs no other
/// program: zip, tar, 7z, and single files, compressed by gzip, xz, bzip2, lzma or zstd.
///
/// A few bytes can be made to unpack to a million times as many. So a member may unpack to kMaxMember bytes, and
/// everything together to kMaxRatio times the archive's size, or to kSmall if that is more; beyond that MeshError
/// is thrown.
class Unpacker {
 public:
  static constexpr std::uint64_t kMaxMember = std::uint64_t{1} << 30, kSmall = std::uint64_t{1} << 26;
  static constexpr std::uint64_t kMaxRatio = 300;

  /// Opens an archive. All members of this class throw MeshError.
  explicit Unpacker(const std::filesystem::path& file);
  /// Opens a zip archive in memory, which must outlive this object; `name` is what errors call it.
  Unpacker(std::string_view zip, const std::string& name);

  /// Goes to the next member that is a file; false at the end.
  bool next();
  const std::string& member() const { return member_; }
  /// How many members came before this one.
  std::size_t position() const { return position_; }

  /// Unpacks the current member. Each can be read only once.
  std::string read();
  /// Unpacks the member only to count its bytes towards the limit.
  void check();

 private:
  struct Close {
    void operator()(archive* a) const;
  };
  void open(int result);
  template <class Take>
  void unpack(const Take& take);
  void count(std::uint64_t bytes);
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_with_library() const;

  std::string name_;
  std::string only_member_;  ///< name of a compressed file's content, which the file does not state
  std::uint64_t packed_ = 0, unpacked_ = 0;
  std::unique_ptr<archive, Close> archive_;
  std::string member_;
  std::size_t position_ = 0;
  std::uint64_t claimed_ = 0;  ///< size of the member as the archive states it
  bool started_ = false, unread_ = false;
};

/// Does the file's name end like that of an archive or of a compressed file?
bool is_archive_name(std::string_view file);

}  // namespace rectilin
