#include "rectilin/retrieval/collection.h"

#include <map>
#include <stdexcept>

#include "rectilin/mesh/source.h"

namespace rectilin::retrieval {

namespace fs = std::filesystem;

Collection find_collection(const fs::path& folder, const Classification& classes) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": is no folder");
  std::map<std::string, std::vector<std::string>> by_stem;
  for (const std::string& file : expand_folders({folder.string()}))
    if (format_of_extension(file)) by_stem[fs::path(file).stem().string()].push_back(file);
  if (by_stem.empty()) throw std::runtime_error(folder.string() + ": there is no mesh file in it");

  Collection collection;
  std::vector<bool> found;
  for (const std::string& model : classes.models) {
    std::vector<std::string> candidates;
    for (const std::string& stem : {model, "m" + model})
      if (const auto files = by_stem.find(stem); files != by_stem.end())
        candidates.insert(candidates.end(), files->second.begin(), files->second.end());
    if (candidates.size() > 1)
      throw std::runtime_error("model '" + model + "' could be " + candidates[0] + " or " + candidates[1]);
    found.push_back(!candidates.empty());
    if (candidates.empty()) collection.missing.push_back(model);
    else collection.files.push_back(candidates[0]);
  }
  collection.classes = classes.subset(found);
  return collection;
}

std::vector<std::string> empty_classes(const Classification& classes) {
  std::vector<bool> used(classes.classes.size());
  for (std::size_t c = classes.classes.size(); c-- > 0;) {  // children come after their parents
    if (!classes.classes[c].models.empty()) used[c] = true;
    if (used[c] && classes.classes[c].parent) used[*classes.classes[c].parent] = true;
  }
  std::vector<std::string> names;
  for (std::size_t c = 0; c < classes.classes.size(); ++c)
    if (!used[c]) names.push_back(classes.path(c));
  return names;
}

}  // namespace rectilin::retrieval
