#include "io/three_mf_parts.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "archive/unpack.h"
#include "io/scene.h"

namespace rectilin {
namespace {

constexpr int kMostNested = 64;

/// The next element's tag, "object id="1" ...", without brackets; nothing at the end.
std::optional<std::string_view> next_tag(std::string_view& xml) {
  const std::size_t begin = xml.find('<');
  if (begin == std::string_view::npos) return std::nullopt;
  xml.remove_prefix(begin + 1);
  const std::string_view tag = xml.substr(0, xml.find('>'));
  xml.remove_prefix(tag.size());
  return tag;
}

/// Whether the tag opens an element of that name, in whatever namespace.
bool opens(std::string_view tag, std::string_view name) {
  std::string_view word = tag.substr(0, tag.find_first_of(" \t\r\n/"));
  if (const std::size_t colon = word.find(':'); colon != std::string_view::npos) word.remove_prefix(colon + 1);
  return word == name;
}

/// An attribute's value, in whatever namespace; empty if there is none.
std::string attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    if (at == 0 || std::string_view(" \t\r\n:").find(tag[at - 1]) == std::string_view::npos) continue;
    std::size_t begin = tag.find_first_not_of(" \t\r\n", at + name.size());
    if (begin == std::string_view::npos || tag[begin] != '=') continue;
    begin = tag.find_first_not_of(" \t\r\n", begin + 1);
    if (begin == std::string_view::npos || (tag[begin] != '"' && tag[begin] != '\'')) continue;
    return std::string(tag.substr(begin + 1, tag.find(tag[begin], begin + 1) - begin - 1));
  }
  return {};
}

/// Objects by their parts and numbers, and the objects that each repeats.
class Components {
 public:
  void add_part(std::string part, std::string_view xml) {
    if (!part.starts_with('/')) part.insert(part.begin(), '/');
    std::string object;
    while (const auto tag = next_tag(xml)) {
      if (opens(*tag, "object")) object = part + '#' + attribute(*tag, "id");
      if (!opens(*tag, "component")) continue;
      const std::string elsewhere = attribute(*tag, "path");
      parts_of_[object].push_back((elsewhere.empty() ? part : elsewhere) + '#' + attribute(*tag, "objectid"));
    }
  }

  void check(const std::string& name) {
    for (const auto& [object, parts] : parts_of_) {
      if (repetitions(object, 0, name) > SceneCost::kPlaced / SceneCost::kInstance)
        throw MeshError(name + ": its components repeat objects more than " +
                        std::to_string(SceneCost::kPlaced / SceneCost::kInstance) + " times");
    }
  }

 private:
  std::uint64_t repetitions(const std::string& object, int depth, const std::string& name) {
    if (depth > kMostNested) throw MeshError(name + ": components are nested too deep");
    const auto parts = parts_of_.find(object);
    if (parts == parts_of_.end()) return 1;
    if (const auto known = known_.find(object); known != known_.end()) return known->second;
    std::uint64_t sum = 0;
    for (const std::string& part : parts->second) sum = SceneCost::sum(sum, repetitions(part, depth + 1, name));
    return known_[object] = sum;
  }

  std::map<std::string, std::vector<std::string>> parts_of_;
  std::map<std::string, std::uint64_t> known_;
};

}  // namespace

void check_3mf_parts(std::string_view zip, const std::string& name) {
  Unpacker unpacker(zip, name);
  Components components;
  while (unpacker.next()) {
    if (unpacker.member().ends_with(".model")) components.add_part(unpacker.member(), unpacker.read());
    else unpacker.check();
  }
  components.check(name);
}

}  // namespace rectilin
