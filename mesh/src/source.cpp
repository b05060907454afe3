#include "rectilin/mesh/source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "archive/members.h"
#include "archive/unpack.h"
#include "io/soup.h"
#include "io/text.h"
#include "manifest.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/mesh/shapes.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kShapePrefix = "shape:";

/// Does the link lead to a folder that it is inside of?
bool leads_back(const fs::path& link) {
  std::error_code error;
  const fs::path target = fs::canonical(link, error);
  if (error) return false;
  const fs::path own = fs::canonical(link.has_parent_path() ? link.parent_path() : fs::path("."), error);
  if (error) return false;
  return std::mismatch(target.begin(), target.end(), own.begin(), own.end()).first == target.end();
}

/// Finds the meshes in a folder and its subfolders.
class Walk {
 public:
  std::vector<std::string> files_below(const fs::path& folder) {
    enter(folder);
    // Links to folders are followed last, so that a folder that can also be reached without a link is found under its
    // own name.
    for (std::size_t i = 0; i < links_.size(); ++i) enter(fs::path(links_[i]));
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  void enter(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (!error && !seen_.insert(real.string()).second) return;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) look_at(*entry);
    if (error) found_.push_back(folder.string());
  }

  void look_at(const fs::directory_entry& entry) {
    const fs::path& path = entry.path();
    std::error_code error;
    const fs::file_status status = entry.status(error);
    const bool link = entry.is_symlink(error);
    if (fs::is_directory(status)) {
      if (link && leads_back(path)) found_.push_back(path.string());
      else if (link) links_.push_back(path.string());
      else enter(path);
    } else if ((format_of_extension(path) || is_archive_name(path.native())) &&
               !path.filename().string().starts_with("._")) {
      // Pipes and devices are not meshes. A file whose status cannot be read is kept, so that the error is reported.
      if (fs::is_regular_file(status) || !fs::exists(status)) found_.push_back(path.string());
    }
  }

  std::vector<std::string> found_, links_;
  std::set<std::string> seen_;
};

bool is_folder(const std::string& source) {
  std::error_code ignored;
  return !is_shape_source(source) && fs::is_directory(source, ignored);
}

bool is_file(const std::string& source) {
  std::error_code ignored;
  return !is_shape_source(source) && fs::is_regular_file(source, ignored);
}

/// Throws the reason why a folder was not replaced by the files in it.
[[noreturn]] void complain_of_folder(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator(folder, error);
  if (error) throw MeshError(folder + ": " + system_reason(error));
  if (fs::is_symlink(folder, error) && leads_back(folder))
    throw MeshError(folder + ": this link leads back to a folder that it is in");
  throw MeshError(folder + ": no mesh file in this folder");
}

/// The pieces of a text that each end with a character; a last piece without it counts if it is not empty.
std::vector<std::string> split(std::string_view text, char end) {
  std::vector<std::string> pieces;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find(end), text.size());
    pieces.emplace_back(text.substr(0, size));
    text.remove_prefix(std::min(size + 1, text.size()));
  }
  return pieces;
}

/// Loads the only mesh of a compressed file. Throws if there is none, or if it is an archive of several.
LoadedMesh load_archive(const std::string& file) {
  const std::vector<std::string> members = mesh_members(file);
  if (members.empty()) throw MeshError(file + ": no mesh file in this archive");
  if (members.size() > 1) throw MeshError(file + ": an archive of " + std::to_string(members.size()) + " meshes");
  return load_mesh(members.front());
}

LoadedMesh load_member(const std::string& source, const MemberName& name) {
  const auto beside = [&](const std::string& path) {
    const fs::path member = (fs::path(name.member).parent_path() / path).lexically_normal();
    try {
      return read_member({name.archive, member.string()});
    } catch (const MeshError&) {
      throw MeshError(source + ": " + rectilin::quoted(path) + " is not in the archive");
    }
  };
  try {
    return read_mesh(read_member(name), source, beside);
  } catch (const std::bad_alloc&) {
    throw MeshError(source + ": not enough memory");
  }
}

bool is_mesh_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string begin(1024, '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  return looks_like_off(begin) || looks_like_ply(begin) || looks_like_stl(begin);
}

/// Is the text a mesh rather than a list? The second word counts, too, as a list may begin with a file called
/// "solid state.off".
bool is_surely_mesh(std::string_view text) {
  const std::string_view begin = text.substr(0, 4096);
  LineReader words(begin, {});
  words.next_word();
  std::int64_t count = 0;
  if (looks_like_off(text)) return parse_integer(words.next_word(), count);
  return (looks_like_ply(text) && words.next_word() == "format") ||
         (looks_like_stl(text) && begin.find("facet") != std::string_view::npos);
}

/// Appends what an entry expands to. A folder's or archive's entry passes its name on: what follows its source in the
/// sources of the parts follows its name in theirs.
void expand(const NamedSource& entry, bool in_manifest, std::vector<NamedSource>& all) {
  const std::size_t before = all.size();
  const auto expand_inner = [&](const std::string& source) {
    NamedSource inner{entry.name + source.substr(std::min(source.size(), entry.source.size())), source, entry.group};
    if (is_archive_name(source) && !parse_member(source)) expand(inner, true, all);
    else all.push_back(std::move(inner));
  };
  try {
    if (is_folder(entry.source)) {
      for (const std::string& file : Walk().files_below(entry.source)) expand_inner(file);
    } else if (is_archive_name(entry.source) && !parse_member(entry.source) && is_file(entry.source)) {
      for (const std::string& member : mesh_members(entry.source)) expand_inner(member);
    } else if (!in_manifest && is_manifest_name(entry.source) && is_file(entry.source) && !is_mesh_text(entry.source)) {
      for (const NamedSource& listed : read_manifest(entry.source)) expand(listed, true, all);
      return;  // no fallback: what is wrong in a list, or an empty list, is for the user to see
    }
  } catch (const fs::filesystem_error&) {  // load_mesh() will report it
  } catch (const MeshError&) {
    if (!in_manifest && is_manifest_name(entry.source)) throw;
    all.resize(before);
  }
  if (all.size() == before) all.push_back(entry);
}

}  // namespace

bool is_shape_source(std::string_view source) { return source.starts_with(kShapePrefix); }

LoadedMesh load_mesh(const std::string& source) {
  if (source.find('\0') != std::string::npos) throw MeshError(printable(source) + ": a name with a NUL character");
  if (is_shape_source(source)) {
    LoadedMesh loaded{make_shape(Spec::parse(std::string_view(source).substr(kShapePrefix.size()))), {}};
    loaded.report.vertices = loaded.mesh.vertices.size();
    loaded.report.polygons = loaded.mesh.triangles.size();
    return loaded;
  }
  std::error_code ignored;  // reading reports it
  const fs::file_status status = fs::status(source, ignored);
  if (fs::is_directory(status)) complain_of_folder(source);
  if (const auto member = parse_member(source); member && !fs::is_regular_file(status))
    return load_member(source, *member);
  return is_archive_name(source) ? load_archive(source) : read_mesh(source);
}

std::vector<NamedSource> expand_sources(const std::vector<std::string>& sources) {
  std::vector<NamedSource> all;
  for (const std::string& source : sources) expand({source, source, {}}, false, all);
  return all;
}

std::vector<std::string> expand_folders(const std::vector<std::string>& sources) {
  std::vector<std::string> all;
  for (NamedSource& entry : expand_sources(sources)) all.push_back(std::move(entry.source));
  return all;
}

std::vector<std::string> sources_in_list(std::string_view list, const std::string& name) {
  if (is_surely_mesh(list)) throw MeshError(name + ": a mesh, not a list of files; /dev/stdin is its name");
  if (list.starts_with("\xFF\xFE") || list.starts_with("\xFE\xFF"))
    throw MeshError(name + ": a list in UTF-16 is not supported, only UTF-8");
  list = without_byte_order_mark(list);
  const bool ended_by_nul = list.find('\0') != std::string_view::npos;
  const std::vector<std::string> items = split(list, ended_by_nul ? '\0' : '\n');
  if (ended_by_nul) {
    // UTF-16 without a byte order mark has a NUL beside every ASCII letter, line ends included.
    const bool utf16 = std::ranges::find(items, "\n") != items.end();
    if (list.back() != '\0' || utf16 || std::ranges::find(items, "") != items.end())
      throw MeshError(name + ": contains NUL characters, but is not a list as find -print0 writes it");
    return items;
  }
  std::vector<std::string> lines;
  for (std::string line : items) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace rectilin
