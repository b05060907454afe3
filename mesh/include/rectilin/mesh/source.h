// Where meshes come from: files, members of archives, folders, lists and built-in shapes, named by one string each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh_io.h"

namespace rectilin {

/// A mesh of a collection. The name tells it from the others wherever the collection lies: the source itself, or what a
/// list says.
struct NamedSource {
  std::string name, source;
  std::string group;  ///< its class, if a list tells it
  bool operator==(const NamedSource&) const = default;
};

/// Whether a source is a built-in shape, `shape:NAME?key=value`.
bool is_shape_source(std::string_view source);

/// Loads a built-in shape, a mesh file, a member of an archive, `archive.zip::path/in/it.obj`, or a compressed file,
/// `chair.off.gz`. Archives may be zip, tar and 7z, compressed by gzip, xz, bzip2, lzma or zstd; a member may unpack to
/// 1 GiB, and an archive to 300 times its size (or 64 MiB). Throws MeshError, also for a folder, or ParameterError for
/// a shape that cannot be made.
LoadedMesh load_mesh(const std::string& source);

/// Replaces each folder by the mesh files and archives in it and below, sorted by path; each archive by the meshes in
/// it, in their order there; and each list by what it names. Other sources stay as they are, existing or not. Links to
/// folders are followed, and each folder is looked into once. What is no mesh but looks like one by its name, the files
/// `._NAME` of macOS, is passed over.
///
/// What cannot be looked at stays in the list in its own place, so that load_mesh() says why: folders that cannot be
/// read or hold no mesh, links to nowhere with the name of a mesh, and links to a folder that they are in.
///
/// A list is a file .txt or .lst of one source a line, with a class behind a tab if there is one, and comments behind
/// #; or a file .csv with columns `source` (or `path`, `file`), `name` and `class` (or `category`, `label`), in any
/// order and among others; the first is needed. Sources in a list are relative to the list's folder, and names are the
/// sources as they stand there if the list gives none. A file .txt whose content is a mesh is one.
std::vector<NamedSource> expand_sources(const std::vector<std::string>& sources);

/// The sources of expand_sources().
std::vector<std::string> expand_folders(const std::vector<std::string>& sources);

/// The names in a list: one a line (LF or CRLF, with or without a UTF-8 byte order mark; empty lines do not count), or
/// each ended by NUL as `find -print0` writes them. Throws MeshError for text with NUL that is not such a list, UTF-16
/// for one, and for what is a mesh itself. `name` stands for the list in errors.
std::vector<std::string> sources_in_list(std::string_view list, const std::string& name);

}  // namespace rectilin
