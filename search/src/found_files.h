// The files that an index is about, before they are read as meshes.
#pragma once

#include <string>
#include <vector>

#include "rectilin/corpus/shard.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

/// From the root, without dots; archives keep the name of their member.
std::string from_root(const std::string& source);

/// Whether a source is `top` or in the folder or archive of that name.
bool is_within(const std::string& source, const std::string& top);

struct FoundFile {
  Member member;      ///< name, source and digest
  std::string error;  ///< why there is no digest
};

/// What the sources name, in the order of the names, which are unique; without digests.
std::vector<FoundFile> find_files(const std::vector<std::string>& sources);

/// Those that are in the shard, with their digests.
std::vector<FoundFile> digested(std::vector<FoundFile> found, const corpus::Shard& shard);

}  // namespace rectilin::search
