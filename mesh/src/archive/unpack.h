// Archives and compressed files, read by libarchive, with a bound on what they unpack to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct archive;

namespace rectilin {

/// Walks through the members of an archive, once, in the order in which they are stored. Only what can be read without
/// running other programs is: zip, tar, 7z, and single files, compressed by gzip, xz, bzip2, lzma or zstd.
///
/// Some bytes can unpack to a million times as many. A member may unpack to kMaxMember bytes, and all that is unpacked
/// to kMaxRatio times the archive's size, or kSmall if that is more; beyond, MeshError.
class Unpacker {
 public:
  static constexpr std::uint64_t kMaxMember = std::uint64_t{1} << 30, kSmall = std::uint64_t{1} << 26;
  static constexpr std::uint64_t kMaxRatio = 300;

  /// `name` stands for the archive in errors. Throws MeshError, also from the other members.
  explicit Unpacker(const std::filesystem::path& file);
  /// Of bytes in memory, which must outlive this: a zip.
  Unpacker(std::string_view zip, const std::string& name);

  /// Goes to the next member that is a file; false at the end.
  bool next();
  const std::string& member() const { return member_; }
  /// How many members came before this one.
  std::size_t position() const { return position_; }

  /// The content of the member, which can be read once.
  std::string read();
  /// Unpacks the member without keeping it, for the bound's sake.
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
  std::string only_member_;  ///< of a compressed file, which does not name it
  std::uint64_t packed_ = 0, unpacked_ = 0;
  std::unique_ptr<archive, Close> archive_;
  std::string member_;
  std::size_t position_ = 0;
  std::uint64_t claimed_ = 0;  ///< size of the member, as the archive has it
  bool started_ = false, unread_ = false;
};

/// Whether the file's name is that of an archive or of a compressed file.
bool is_archive_name(std::string_view file);

}  // namespace rectilin
