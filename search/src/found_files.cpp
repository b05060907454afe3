#include "found_files.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "rectilin/mesh/source.h"
#include "rectilin/search/digest.h"

namespace rectilin::search {

namespace fs = std::filesystem;

std::string from_root(const std::string& source) {
  const std::string file = file_of(source);
  if (file.empty()) return source;
  return fs::absolute(file).lexically_normal().string() + source.substr(file.size());
}

bool is_within(const std::string& source, const std::string& top) {
  if (!source.starts_with(top)) return false;
  if (source.size() == top.size() || top.ends_with('/')) return true;
  return source[top.size()] == '/' || source.substr(top.size(), 2) == "::";
}

std::vector<FoundFile> find_files(const std::vector<std::string>& sources) {
  std::multimap<std::string, std::string> named;  // sources by name
  std::set<std::string> seen;
  for (NamedSource& source : expand_sources(sources))
    if (std::string path = from_root(source.source); seen.insert(path).second)
      named.emplace(std::move(source.name), std::move(path));
  std::vector<FoundFile> found(named.size());
  for (std::size_t i = 0; const auto& [name, source] : named) {
    found[i].member.name = name;
    found[i++].member.source = source;
  }
  for (std::size_t i = 1; i < found.size(); ++i)  // two lists may use one name
    if (found[i].member.name == found[i - 1].member.name) found[i].member.name = found[i].member.source;
  return found;
}

std::vector<FoundFile> digested(std::vector<FoundFile> found, const corpus::Shard& shard) {
  std::erase_if(found, [&](const FoundFile& f) { return !shard.contains(f.member.name); });
  std::map<std::string, std::optional<std::string>> digest_of;  // of each file once: an archive holds many members
  for (const FoundFile& f : found) digest_of.try_emplace(file_of(f.member.source));
  std::vector<std::pair<const std::string, std::optional<std::string>>*> files;
  for (auto& file : digest_of) files.push_back(&file);
  tbb::parallel_for(std::size_t{0}, files.size(), [&](std::size_t i) {
    files[i]->second = files[i]->first.empty() ? std::string() : file_digest(files[i]->first);
  });
  for (FoundFile& f : found) {
    if (const auto& digest = digest_of[file_of(f.member.source)])
      f.member.digest = source_digest(f.member.source, *digest);
    else f.error = why_no_digest(f.member.source);
  }
  return found;
}

}  // namespace rectilin::search
