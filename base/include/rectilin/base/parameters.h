// Settings given as text, `NAME?key=value`, for everything that is made by name: optimizers, shapes,
// poses, descriptors.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rectilin/base/json_text.h"
#include "rectilin/base/parameter_error.h"

namespace rectilin {

/// A name and its settings as typed on a command line: `NAME?key=value&key=value`. A value that reads as a JSON number,
/// boolean or null becomes one; any other value is a string.
struct Spec {
  std::string name;
  Json settings = Json::object();

  /// Throws ParameterError for an empty name or key, a missing '=' or a key given twice.
  static Spec parse(std::string_view text);
};

/// Reads three numbers "x,y,z", each within [lower, upper], into `target`. Returns false, and leaves `target` alone, if
/// the value is anything else.
bool read_vector3(const Json& value, std::array<double, 3>& target, double lower, double upper);

/// Connects the fields of an options struct with names, accepted ranges and a line of help each, so that one table
/// serves to read settings, check them, write them and document them. It holds references to the fields and must not
/// outlive them.
class Parameters {
 public:
  Parameters& integer(std::string name, int& target, int lower, int upper, std::string help);
  Parameters& real(std::string name, double& target, double lower, double upper, std::string help);
  Parameters& seed(std::string name, std::uint64_t& target, std::string help);
  Parameters& flag(std::string name, bool& target, std::string help);

  /// Three numbers, see read_vector3().
  Parameters& vector3(std::string name, std::array<double, 3>& target, double lower, double upper, std::string help);

  /// A setting of any other kind. `accepts` says in words what is accepted, and `assign` returns false for a value that
  /// is not.
  Parameters& custom(std::string name, std::string accepts, std::function<bool(const Json&)> assign,
                     std::function<Json()> read, std::string help);

  /// A choice among a few words, each standing for a value of an enumeration.
  template <class Enum>
  Parameters& choice(std::string name, Enum& target, std::vector<std::pair<std::string, Enum>> words,
                     std::string help) {
    std::vector<std::string> names;
    for (const auto& [word, value] : words) names.push_back(word);
    return add_choice(
        std::move(name), std::move(names), [&target, words](std::size_t i) { target = words[i].second; },
        [&target, words] {
          std::size_t i = 0;
          while (i + 1 < words.size() && words[i].second != target) ++i;
          return i;
        },
        std::move(help));
  }

  /// Sets the fields named in `settings`, a JSON object. `owner` is what error messages call the thing that is set.
  /// Throws ParameterError for an unknown name, a wrong type or a value out of range; fields set before the error keep
  /// their new values.
  void set(const Json& settings, std::string_view owner);

  /// All fields with their current values, in the order in which they were bound.
  Json values() const;

  struct Description {
    std::string name, accepts, help;
    Json value;  ///< its current value; the default, in a newly made options struct
  };
  std::vector<Description> describe() const;

 private:
  struct Entry {
    std::string name, accepts, help;
    std::function<bool(const Json&)> assign;  ///< false if the value is not acceptable
    std::function<Json()> read;
  };
  Parameters& add_choice(std::string name, std::vector<std::string> words, std::function<void(std::size_t)> assign,
                         std::function<std::size_t()> read, std::string help);
  std::vector<Entry> entries_;
};

}  // namespace rectilin
