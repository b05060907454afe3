#include "archive/members.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "archive/unpack.h"
#include "archive/zip_index.h"
#include "rectilin/base/fnv1a.h"
#include "rectilin/mesh/mesh_io.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeparator = "::";

/// A file as it was when it was opened. A file that has been written since then has another state.
struct FileState {
  std::string path;
  std::int64_t size = 0, changed = 0;  ///< bytes, and nanoseconds since 1970
  bool operator==(const FileState&) const = default;
};

FileState state_of(const std::string& path) {
  struct stat about {};  // all zero if the file is missing: opening it says so
  if (stat(path.c_str(), &about) != 0) return {path};
  return {path, about.st_size, std::int64_t{about.st_mtim.tv_sec} * 1'000'000'000 + about.st_mtim.tv_nsec};
}

bool is_zip_name(std::string_view file) {
  return file.size() >= 4 && std::ranges::equal(file.substr(file.size() - 4), std::string_view(".zip"), {},
                                                [](unsigned char c) { return std::tolower(c); });
}

std::uint64_t hash_of(std::string_view member) { return Fnv1a().add(member).value(); }

/// Archives that are kept open, each standing at some member, and the places of the members seen so far.
class OpenArchives {
 public:
  std::string read(const MemberName& name) {
    const FileState file = state_of(name.archive);
    if (is_zip_name(name.archive)) {
      if (auto content = zip_index(file)->read(name.member)) return *std::move(content);
    }
    std::unique_ptr<Unpacker> unpacker = take(file, name.member);
    // A second round is needed when two names have the same hash, or when the archive was open behind the member.
    for (int round = 0; round < 2; ++round) {
      if (!unpacker) unpacker = std::make_unique<Unpacker>(fs::path(name.archive));
      while (unpacker->next()) {
        remember(file, *unpacker);
        if (unpacker->member() != name.member) continue;
        std::string content = unpacker->read();
        give_back(file, std::move(unpacker));
        return content;
      }
      unpacker.reset();
    }
    throw MeshError(name.archive + std::string(kSeparator) + name.member + ": no such member");
  }

 private:
  static constexpr std::size_t kMaxOpen = 8, kMaxIndexed = 4;

  struct Open {
    FileState file;
    std::unique_ptr<Unpacker> unpacker;
  };
  struct Zip {
    FileState file;
    std::shared_ptr<const ZipIndex> index;
  };
  struct Index {
    FileState file;
    std::unordered_map<std::uint64_t, std::size_t> positions;
    std::size_t passed = 0;  ///< number of members that the index covers
  };

  /// Takes the open archive that stands before the member, as near to it as possible; none if the archive must be
  /// opened anew.
  std::unique_ptr<Unpacker> take(const FileState& file, const std::string& member) {
    const std::lock_guard lock(mutex_);
    const Index& index = index_of(file);
    const auto known = index.positions.find(hash_of(member));
    const std::size_t end = known != index.positions.end() ? known->second : index.passed;
    auto best = open_.end();
    for (auto it = open_.begin(); it != open_.end(); ++it) {
      if (it->file != file || it->unpacker->position() >= end) continue;
      if (best == open_.end() || it->unpacker->position() > best->unpacker->position()) best = it;
    }
    if (best == open_.end()) return nullptr;
    auto unpacker = std::move(best->unpacker);
    open_.erase(best);
    return unpacker;
  }

  void give_back(const FileState& file, std::unique_ptr<Unpacker> unpacker) {
    const std::lock_guard lock(mutex_);
    open_.push_front({file, std::move(unpacker)});
    if (open_.size() > kMaxOpen) open_.pop_back();
  }

  void remember(const FileState& file, const Unpacker& unpacker) {
    const std::lock_guard lock(mutex_);
    Index& index = index_of(file);
    index.positions.try_emplace(hash_of(unpacker.member()), unpacker.position());
    index.passed = std::max(index.passed, unpacker.position() + 1);
  }

  Index& index_of(const FileState& file) {
    const auto found = std::ranges::find(indices_, file, &Index::file);
    if (found != indices_.end()) {
      indices_.splice(indices_.begin(), indices_, found);
    } else {
      indices_.push_front({file, {}, 0});
      if (indices_.size() > kMaxIndexed) indices_.pop_back();
    }
    return indices_.front();
  }

  std::shared_ptr<const ZipIndex> zip_index(const FileState& file) {
    const std::lock_guard lock(zip_mutex_);  // others who want the same table wait until it has been read
    auto found = std::ranges::find(zips_, file, &Zip::file);
    if (found == zips_.end()) {
      zips_.push_front({file, std::make_shared<const ZipIndex>(file.path)});
      if (zips_.size() > kMaxIndexed) zips_.pop_back();
      found = zips_.begin();
    }
    zips_.splice(zips_.begin(), zips_, found);
    return found->index;
  }

  std::mutex mutex_, zip_mutex_;
  std::list<Zip> zips_;       ///< most recently used first
  std::list<Open> open_;      ///< likewise
  std::list<Index> indices_;  ///< likewise
};

/// Is the member a mesh? macOS puts "._x.obj" beside x.obj, which is none. Names with control characters are left out:
/// they would break the lines that lists and errors are made of.
bool is_mesh_member(const std::string& member) {
  if (std::ranges::any_of(member, [](unsigned char c) { return c < ' '; })) return false;
  const fs::path path(member);
  return format_of_extension(path) && !path.filename().string().starts_with("._");
}

}  // namespace

std::optional<MemberName> parse_member(std::string_view source) {
  for (std::size_t at = source.find(kSeparator); at != std::string_view::npos; at = source.find(kSeparator, at + 1)) {
    if (is_archive_name(source.substr(0, at)))
      return MemberName{std::string(source.substr(0, at)), std::string(source.substr(at + kSeparator.size()))};
  }
  return std::nullopt;
}

std::vector<std::string> mesh_members(const std::string& archive) {
  std::vector<std::string> sources;
  Unpacker unpacker{fs::path(archive)};
  while (unpacker.next()) {
    if (is_mesh_member(unpacker.member())) sources.push_back(archive + std::string(kSeparator) + unpacker.member());
  }
  return sources;
}

std::string read_member(const MemberName& name) {
  static OpenArchives archives;
  return archives.read(name);
}

}  // namespace rectilin
