// Many stores into one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rectilin::corpus {

/// A mesh of which two stores say different things.
struct Conflict {
  std::string name, store, reason;
};

struct MergeSummary {
  std::size_t rows = 0;         ///< in the target, afterwards
  std::size_t added = 0;        ///< meshes that were not in it, or of which less was known
  std::size_t conflicts = 0;    ///< all of them
  std::vector<Conflict> first;  ///< the first of each store
};

/// Adds the stores' meshes to the target, which is made if it does not exist. Of a mesh in several stores the row that
/// says most is taken (done, failed, limited, left), and the target's own of two that say as much; two results that
/// differ, or two digests, are a conflict. Doing it twice changes nothing. Of each store all is added or
/// nothing, whenever the program ends.
/// Throws ParameterError if the stores are of different tasks, std::runtime_error if one cannot be read or written.
MergeSummary merge(std::span<const std::filesystem::path> stores, const std::filesystem::path& target);

}  // namespace rectilin::corpus
