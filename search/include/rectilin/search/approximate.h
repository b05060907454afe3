// The most similar members of a very large collection, found by walking from neighbour to neighbour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/search/database.h"
#include "rectilin/search/nearest.h"

namespace rectilin::search {

/// What load() found.
enum class GraphFile {
  kTaken,    ///< a graph of these members, or of the first of them
  kMissing,  ///< no file
  kDamaged,  ///< cut off, or with changed bytes
  kOther,    ///< a graph of other members: some were removed or described again since
};

/// A graph in which each member is linked to a few that are near it (hierarchical navigable small world, Malkov and
/// Yashunin 2020; MalkovYashunin2020 in papers/references.bib), built and walked by hnswlib. A search looks at some
/// hundreds of members, however many there are, and so may miss some of the nearest; the distances of those it finds
/// are exact.
///
/// The graph is by NearestSearch::rough_distance(), a tenth of the price of the distance; what the walk finds is then
/// compared in full. Members with the same signature are one node, so that many copies of one file cannot take all of
/// each other's links. The graph depends only on the signatures in the order of the members' ids: it is the same bytes
/// each time, whether it was built at once or in parts.
class ApproximateSearch {
 public:
  /// `search` must stay as it is while this is used; `ids` are what its members are known by for good, all different
  /// (Member::id). New members get ids above those that are there.
  ApproximateSearch(const NearestSearch& search, const std::vector<std::int64_t>& ids);
  ~ApproximateSearch();
  ApproximateSearch(const ApproximateSearch&) = delete;
  ApproximateSearch& operator=(const ApproximateSearch&) = delete;

  /// Adds the members that the graph lacks, on one thread. False if it was stopped: the graph then has the first of
  /// them and can be saved, loaded and gone on with.
  bool build(const LoopControl& control = {});
  bool complete() const;
  std::size_t nodes() const;  ///< in the graph by now: members with different signatures

  /// Takes the graph of a file that save() wrote, if it is of these members or the first of them. Nothing in the file
  /// is trusted. Throws std::runtime_error if the file is of another kind or cannot be read.
  GraphFile load(const std::filesystem::path& file);
  /// The whole file or none of it. Throws std::runtime_error.
  void save(const std::filesystem::path& file) const;
  std::string bytes() const;  ///< what save() writes

  /// As NearestSearch::nearest(): the n nearest of those for which `keep` is true. Where the graph would have to be
  /// walked through in large part, for a large n or a filter that few pass, the exact search is asked. Thread safe.
  /// Throws std::logic_error unless complete().
  std::vector<Neighbour> nearest(const Parts& query, std::size_t n,
                                 const std::function<bool(std::size_t)>& keep = {}) const;
  /// By the graph alone, without a filter: the n nearest of the `width` that a walk ends with.
  std::vector<Neighbour> walk(const Parts& query, std::size_t n, std::size_t width) const;

 private:
  std::vector<Neighbour> candidates(const Parts& query, std::size_t width,
                                    const std::function<bool(std::size_t)>& keep) const;
  std::vector<Neighbour> nearest_of(const Parts& query, std::vector<Neighbour> candidates, std::size_t n) const;

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Answers one search in the way that is asked for: with the graph if there is one, by diffusion if `by_diffusion`.
std::vector<Neighbour> find_nearest(const NearestSearch& search, const ApproximateSearch* graph, const Parts& query,
                                    std::size_t n, const std::function<bool(std::size_t)>& keep, bool by_diffusion);

/// Where the graph of a database is kept: beside it, as FILE-graph.
std::filesystem::path graph_file(const std::filesystem::path& database);

/// The complete graph of a collection: that of the file, with what is missing added and saved. `note` gets a line if
/// something was amiss: a damaged file, which is replaced, or one that cannot be written. Throws Stopped, with what was
/// built so far in the file, and std::runtime_error if the file is of another kind, which is left as it is.
std::unique_ptr<ApproximateSearch> open_approximate(const NearestSearch& search, const std::vector<std::int64_t>& ids,
                                                    const std::filesystem::path& file, const LoopControl& control,
                                                    std::string& note);
/// The same for the members of a database in the order in which `search` has them.
std::unique_ptr<ApproximateSearch> open_approximate(const NearestSearch& search, std::span<const Member> members,
                                                    const std::filesystem::path& file, const LoopControl& control,
                                                    std::string& note);

}  // namespace rectilin::search
