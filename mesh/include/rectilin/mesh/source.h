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
/// 1 GiB, and an archive to 300 times its size (or 64 MiB). Throws MeshError, also for a folder, or ParameterError for a
/// shape that cannot be made.
LoadedMesh load_mesh(const std::string& source);

/// Replaces each folder by the mesh files and archives in it and below, sorted by path; each archive by the meshes in
/// it, in their order there; and each list by what it names. Other sources stay as they are, existing or not, and so do
/// those that cannot be read or in which there is no mesh, for load_mesh() to say why.
///
/// A list is a file .txt or .lst of one source a line, with a class behind a tab if there is one, and comments behind #;
/// or a file .csv with columns `source` (or `path`, `file`), `name` and `class` (or `category`, `label`), in any order
/// and among others; the first is needed. Sources in a list are relative to the list's folder, and names are the sources
/// as they stand there if the list gives none. A file .txt whose content is a mesh is one.
std::vector<NamedSource> expand_sources(const std::vector<std::string>& sources);

/// The sources of expand_sources().
std::vector<std::string> expand_folders(const std::vector<std::string>& sources);

}  // namespace rectilin
