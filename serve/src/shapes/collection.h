// A database of shapes, read into memory once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "rectilin/search/approximate.h"
#include "rectilin/search/database.h"
#include "rectilin/search/nearest.h"

namespace rectilin::serve {

struct Page {
  std::size_t total = 0;             ///< members that the names allow
  std::vector<std::size_t> members;  ///< the part asked for
};

/// Immutable once it is made, so thread safe.
class Collection {
 public:
  /// Throws what search::Database throws.
  explicit Collection(search::Database database);

  /// Searches by the graph in a file from now on, see search::open_approximate(). Returns its note.
  std::string use_graph(const std::filesystem::path& file, const LoopControl& control);

  const std::string& descriptor() const { return descriptor_; }
  std::size_t failed() const { return failed_; }  ///< members that have no signature
  std::size_t size() const { return members_.size(); }
  const search::Member& member(std::size_t i) const { return members_[i]; }
  std::optional<std::size_t> find(std::int64_t id) const;
  search::Parts parts_of(std::size_t i) const { return search_.parts_of(i); }

  /// Members in the order of their names whose names have all words of `words`, large or small letters.
  Page page(const std::string& words, std::size_t from, std::size_t count) const;

  /// The nearest without `except`, likewise.
  std::vector<search::Neighbour> nearest(const search::Parts& query, std::size_t count, const std::string& words,
                                         std::optional<std::size_t> except, bool by_diffusion) const;

  /// Whether signatures are of the sizes that those of this database have.
  bool fits(const search::Parts& parts) const;

 private:
  std::string descriptor_;
  std::size_t failed_ = 0;
  std::vector<search::Member> members_;
  std::vector<std::string> small_names_;  // in small letters
  std::unordered_map<std::int64_t, std::size_t> places_;
  search::NearestSearch search_;
  std::unique_ptr<search::ApproximateSearch> graph_;
};

}  // namespace rectilin::serve
