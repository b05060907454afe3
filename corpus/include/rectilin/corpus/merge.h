// Merges stores, such as those of the shards of one collection.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

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

/// Adds the meshes of the stores to the target, which is made if it does not exist. If several stores have a mesh, the
/// row that says most is kept (in this order: done, failed, limited, left); of rows that say as much, the target's own.
/// Two different results, or two different digests, for one mesh are a conflict. Merging the same store again changes
/// nothing. A store is added as a whole or not at all, whenever the program ends. Throws ParameterError if the stores
/// are of different tasks, std::runtime_error if one cannot be read or written.
MergeSummary merge(std::span<const std::filesystem::path> stores, const std::filesystem::path& target);

}  // namespace rectilin::corpus
