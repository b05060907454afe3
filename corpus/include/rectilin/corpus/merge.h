// Merges stores, such as those of the shards of one collection.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rectilin/corpus/sqlite.h"

namespace rectilin::corpus {

/// A mesh about which two stores disagree.
struct Conflict {
  std::string name, store, reason;
};

struct MergeSummary {
  std::size_t rows = 0;         ///< rows in the target after merging
  std::size_t added = 0;        ///< meshes that the target did not have, or knew less about
  std::size_t conflicts = 0;    ///< how many conflicts there were
  std::vector<Conflict> first;  ///< the first conflict of each store
};

/// How files of one kind are merged, in SQL: the other file is `part`, the target `main`.
struct MergeSql {
  std::string conflicts;          ///< selects, for each conflict, the mesh's name and whether it is another mesh (1, 0)
  std::vector<std::string> take;  ///< statements that take over what the target lacks
  std::size_t counted = 0;        ///< the one of them that changes a row for each mesh taken
};

/// Adds a file to the target, as a whole or not at all, and counts what it adds.
void merge_file(Database& target, const std::filesystem::path& file, const MergeSql& sql, MergeSummary& summary);

/// Throws ParameterError if there are no files, or one of them is the target.
void check_merge(std::span<const std::filesystem::path> files, const std::filesystem::path& target);

/// Adds the meshes of the stores to the target, which is made if it does not exist. If several stores have a mesh, the
/// row that says most is kept (in this order: done, failed, limited, left); of rows that say as much, the target's own.
/// Two different results, or two different digests, for one mesh are a conflict. Merging the same store again changes
/// nothing. A store is added as a whole or not at all, whenever the program ends. Throws ParameterError if the stores
/// are of different tasks, std::runtime_error if one cannot be read or written.
MergeSummary merge(std::span<const std::filesystem::path> stores, const std::filesystem::path& target);

}  // namespace rectilin::corpus
