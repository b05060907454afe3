// Named settings for everything that is made from a string: optimizers, shapes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rectilin/base/json_fwd.h"
#include "rectilin/base/parameter_error.h"

namespace rectilin {

/// A name and its settings as typed on a command line: `NAME?key=value&key=value`. A value that reads
/// as a JSON number, boolean or null is one; any other is a string.
struct Spec {
  std::string name;
  Json settings = Json::object();

  /// Throws ParameterError for an empty name or key, a missing '=' or a key given twice.
  static Spec parse(std::string_view text);
};

/// Reads the string "x,y,z", each number within [lower, upper]. Returns false and changes nothing if the
/// value is anything else.
bool read_vector3(const Json& value, std::array<double, 3>& target, double lower, double upper);

/// Binds the fields of an options struct to names, ranges and one line of help each, so that one table
/// serves reading, checking, writing and documenting them. Holds references: it must not outlive the
/// fields it binds.
class Parameters {
 public:
  Parameters& integer(std::string name, int& target, int lower, int upper, std::string help);
  Parameters& real(std::string name, double& target, double lower, double upper, std::string help);
  Parameters& seed(std::string name, std::uint64_t& target, std::string help);
  Parameters& flag(std::string name, bool& target, std::string help);

  /// Three numbers, see read_vector3().
  Parameters& vector3(std::string name, std::array<double, 3>& target, double lower, double upper, std::string help);

  /// Any other kind of value, `accepts` in words; `assign` returns false if a value is not acceptable.
  Parameters& custom(std::string name, std::string accepts, std::function<bool(const Json&)> assign,
                     std::function<Json()> read, std::string help);

  /// One of a few words, each standing for a value of an enumeration.
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

  /// Sets the fields named in `settings`, a JSON object. `owner` names the thing in errors. Throws
  /// ParameterError for an unknown name, a wrong type or a value out of range; fields set before the
  /// error stay set.
  void set(const Json& settings, std::string_view owner);

  /// All fields with their present values, in the order they were bound.
  Json values() const;

  struct Description {
    std::string name, accepts, help;
    Json value;  ///< present value; the default when asked of a fresh options struct
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
