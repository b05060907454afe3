// Merges databases, such as those of the shards of one collection.
#pragma once

#include <filesystem>
#include <span>

#include "rectilin/corpus/merge.h"

namespace rectilin::search {

/// Adds the members of the databases to the target, which is made if it does not exist. If several have a member, the
/// row that says most is kept (in this order: done, failed, left); of rows that say as much, the target's own. Other
/// bytes of a file, or another signature, under one name are a conflict. Merging the same database again changes
/// nothing; one is added as a whole or not at all. Throws ParameterError if the databases are of different descriptors,
/// std::runtime_error if one cannot be read or written.
corpus::MergeSummary merge_databases(std::span<const std::filesystem::path> files, const std::filesystem::path& target);

}  // namespace rectilin::search
