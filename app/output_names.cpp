#include "output_names.h"

#include <cctype>
#include <filesystem>
#include <map>

namespace rectilin::app {

std::vector<std::string> output_names(const std::vector<std::string>& sources) {
  std::map<std::string, int> taken;
  std::vector<std::string> names;
  for (const std::string& source : sources) {
    std::string name = source.starts_with("shape:") ? source.substr(6) : std::filesystem::path(source).stem().string();
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.' && !(c & 0x80)) c = '_';
    if (name.empty() || name.front() == '.') name = "mesh" + name;
    const auto small = [](std::string text) {
      for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return text;
    };
    std::string unique = name;
    for (int i = 2; !taken.emplace(small(unique), 0).second; ++i) unique = name + "_" + std::to_string(i);
    names.push_back(unique);
  }
  return names;
}

}  // namespace rectilin::app
