#include "shapes/collection.h"

#include <algorithm>
#include <sstream>

namespace rectilin::serve {
namespace {

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

class Words {
 public:
  explicit Words(const std::string& text) {
    std::istringstream in(small_letters(text));
    for (std::string word; in >> word;) words_.push_back(word);
  }
  bool in(const std::string& name) const {
    return std::ranges::all_of(words_, [&](const std::string& w) { return name.find(w) != std::string::npos; });
  }
  bool none() const { return words_.empty(); }

 private:
  std::vector<std::string> words_;
};

}  // namespace

Collection::Collection(search::Database database) : descriptor_(database.descriptor()), search_(descriptor_) {
  for (const search::Member& m : database.members())
    if (m.status == search::MemberStatus::kFailed) ++failed_;
  search_.reserve(database.described());
  database.for_each_signature([this](search::Member&& member, search::Parts&& parts) {
    search_.add(parts);
    places_[member.id] = members_.size();
    small_names_.push_back(small_letters(member.name));
    members_.push_back(std::move(member));
  });
}

std::string Collection::use_graph(const std::filesystem::path& file, const LoopControl& control) {
  std::string note;
  graph_ = search::open_approximate(search_, members_, file, control, note);
  return note;
}

std::optional<std::size_t> Collection::find(std::int64_t id) const {
  const auto found = places_.find(id);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

Page Collection::page(const std::string& text, std::size_t from, std::size_t count) const {
  const Words words(text);
  Page page;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (!words.in(small_names_[i])) continue;
    if (page.total >= from && page.members.size() < count) page.members.push_back(i);
    ++page.total;
  }
  return page;
}

std::vector<search::Neighbour> Collection::nearest(const search::Parts& query, std::size_t count,
                                                   const std::string& text, std::optional<std::size_t> except,
                                                   bool by_diffusion) const {
  if (members_.empty()) return {};
  const Words words(text);
  const auto keep = [&](std::size_t i) { return i != except && (words.none() || words.in(small_names_[i])); };
  return search::find_nearest(search_, graph_.get(), query, count, keep, by_diffusion);
}

bool Collection::fits(const search::Parts& parts) const {
  if (members_.empty()) return true;
  const search::Parts own = search_.parts_of(0);
  return std::ranges::equal(own, parts, [](const auto& a, const auto& b) { return a.size() == b.size(); });
}

}  // namespace rectilin::serve
