// Sources: the strings that say where a mesh comes from. Files, members of archives, folders, lists and
// built-in shapes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh_io.h"

namespace rectilin {

/// A mesh of a collection. Its name stays the same wherever the collection is stored: it is the source as given, or the
/// name that a list gives it.
struct NamedSource {
  std::string name, source;
  std::string group;  ///< the mesh's class, if a list says so
  bool operator==(const NamedSource&) const = default;
};

/// Is the source a built-in shape, `shape:NAME?key=value`?
bool is_shape_source(std::string_view source);

/// Loads a built-in shape, a mesh file, a member of an archive (`archive.zip::path/in/it.obj`) or a compressed file
/// (`chair.off.gz`). Archives may be zip, tar and 7z, compressed by gzip, xz, bzip2, lzma or zstd. A member may unpack
/// to 1 GiB, an archive to 300 times its size (or to 64 MiB, if that is more). Throws MeshError, also for a folder, and
/// ParameterError for a shape that cannot be made.
LoadedMesh load_mesh(const std::string& source);

/// Replaces each folder by the mesh files and archives in it and in its subfolders, sorted by path; each archive by the
/// meshes in it, in their order there; and each list by what it names. Other sources stay as they are, whether they
/// exist or not. Links to folders are followed, but no folder is visited twice. Files that only look like meshes by
/// their names, such as the `._NAME` files of macOS, are skipped.
///
/// A source that cannot be opened stays in the result, so that load_mesh() can report the reason: folders that cannot
/// be read or hold no mesh, links with the name of a mesh that lead nowhere, and links to a folder that they are
/// inside of.
///
/// A list is a .txt or .lst file with one source a line, optionally a class after a tab, and comments after #; or a
/// .csv file with the columns `source` (or `path`, `file`), `name` and `class` (or `category`, `label`) in any order
/// and among others. Only `source` is required. Sources in a list are relative to the list's folder; their names are
/// the sources as written there, unless the list gives others. A .txt file that contains a mesh is read as a mesh.
std::vector<NamedSource> expand_sources(const std::vector<std::string>& sources);

/// Only the sources of expand_sources(), without names and classes.
std::vector<std::string> expand_folders(const std::vector<std::string>& sources);

/// The names in a list of files as other programs print it: one a line (LF or CRLF, with or without a UTF-8 byte order
/// mark; empty lines are ignored), or each ended by NUL, as `find -print0` writes them. Throws MeshError for text that
/// contains NUL but is not such a list, UTF-16 for example, and for text that is itself a mesh. `name` is what errors
/// call the list.
std::vector<std::string> sources_in_list(std::string_view list, const std::string& name);

}  // namespace rectilin
