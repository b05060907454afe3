#include "rectilin/base/parameters.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>

namespace rectilin {
namespace {

std::string join(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string number(double x) {
  char text[32];
  return {text, std::to_chars(std::begin(text), std::end(text), x, std::chars_format::general, 6).ptr};
}

Json value_of(std::string_view text) {
  if (text == "null") return Json();
  Json value = parse_json_or_null(text);
  return value.is_primitive() && !value.is_null() ? value : Json(std::string(text));
}

/// Is it a JSON number with a whole value inside [lower, upper]?
bool is_integer_within(const Json& value, double lower, double upper) {
  if (!value.is_number()) return false;
  const double x = value.get<double>();
  return x >= lower && x <= upper && x == static_cast<double>(static_cast<long long>(x));
}

}  // namespace

Spec Spec::parse(std::string_view text) {
  const auto question = text.find('?');
  Spec spec{std::string(text.substr(0, question))};
  if (spec.name.empty()) throw ParameterError("'" + std::string(text) + "' has no name");
  if (question == std::string_view::npos) return spec;
  std::string_view rest = text.substr(question + 1);
  while (!rest.empty()) {
    const auto ampersand = std::min(rest.find('&'), rest.size());
    const std::string_view pair = rest.substr(0, ampersand);
    rest.remove_prefix(std::min(ampersand + 1, rest.size()));
    const auto equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0)
      throw ParameterError(spec.name + ": '" + std::string(pair) + "' is not key=value");
    const std::string key(pair.substr(0, equals));
    if (spec.settings.contains(key)) throw ParameterError(spec.name + ": '" + key + "' is given twice");
    spec.settings[key] = value_of(pair.substr(equals + 1));
  }
  return spec;
}

Parameters& Parameters::integer(std::string name, int& target, int lower, int upper, std::string help) {
  entries_.push_back({std::move(name), "integer, " + std::to_string(lower) + " to " + std::to_string(upper),
                      std::move(help),
                      [&target, lower, upper](const Json& value) {
                        if (!is_integer_within(value, lower, upper)) return false;
                        target = static_cast<int>(value.get<double>());
                        return true;
                      },
                      [&target] { return Json(target); }});
  return *this;
}

Parameters& Parameters::real(std::string name, double& target, double lower, double upper, std::string help) {
  const bool bounded = upper < std::numeric_limits<double>::max();
  entries_.push_back({std::move(name), "number, " + number(lower) + (bounded ? " to " + number(upper) : " or more"),
                      std::move(help),
                      [&target, lower, upper](const Json& value) {
                        if (!value.is_number()) return false;
                        const double x = value.get<double>();
                        if (!(x >= lower && x <= upper)) return false;
                        target = x;
                        return true;
                      },
                      [&target] { return Json(target); }});
  return *this;
}

Parameters& Parameters::seed(std::string name, std::uint64_t& target, std::string help) {
  entries_.push_back({std::move(name), "integer, 0 or more", std::move(help),
                      [&target](const Json& value) {
                        if (!value.is_number_unsigned()) return false;
                        target = value.get<std::uint64_t>();
                        return true;
                      },
                      [&target] { return Json(target); }});
  return *this;
}

Parameters& Parameters::flag(std::string name, bool& target, std::string help) {
  entries_.push_back({std::move(name), "true or false", std::move(help),
                      [&target](const Json& value) {
                        if (!value.is_boolean()) return false;
                        target = value.get<bool>();
                        return true;
                      },
                      [&target] { return Json(target); }});
  return *this;
}

bool read_vector3(const Json& value, std::array<double, 3>& target, double lower, double upper) {
  if (!value.is_string()) return false;
  const auto& text = value.get_ref<const std::string&>();
  const char *at = text.data(), *const end = at + text.size();
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return false;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !(numbers[i] >= lower && numbers[i] <= upper)) return false;
    at = next;
  }
  if (at != end) return false;
  target = numbers;
  return true;
}

Parameters& Parameters::vector3(std::string name, std::array<double, 3>& target, double lower, double upper,
                                std::string help) {
  return custom(
      std::move(name), "three numbers x,y,z, " + number(lower) + " to " + number(upper),
      [&target, lower, upper](const Json& value) { return read_vector3(value, target, lower, upper); },
      [&target] { return Json(to_text(target[0]) + "," + to_text(target[1]) + "," + to_text(target[2])); },
      std::move(help));
}

Parameters& Parameters::custom(std::string name, std::string accepts, std::function<bool(const Json&)> assign,
                               std::function<Json()> read, std::string help) {
  entries_.push_back({std::move(name), std::move(accepts), std::move(help), std::move(assign), std::move(read)});
  return *this;
}

Parameters& Parameters::add_choice(std::string name, std::vector<std::string> words,
                                   std::function<void(std::size_t)> assign, std::function<std::size_t()> read,
                                   std::string help) {
  entries_.push_back({std::move(name), join(words, " | "), std::move(help),
                      [words, assign](const Json& value) {
                        if (!value.is_string()) return false;
                        const auto at = std::find(words.begin(), words.end(), value.get<std::string>());
                        if (at == words.end()) return false;
                        assign(static_cast<std::size_t>(at - words.begin()));
                        return true;
                      },
                      [words, read] { return Json(words[read()]); }});
  return *this;
}

void Parameters::set(const Json& settings, std::string_view owner) {
  for (const auto& [key, value] : settings.items()) {
    const auto entry =
        std::find_if(entries_.begin(), entries_.end(), [&key = key](const Entry& e) { return e.name == key; });
    if (entry == entries_.end()) {
      std::vector<std::string> names;
      for (const auto& e : entries_) names.push_back(e.name);
      throw ParameterError(std::string(owner) + ": no parameter '" + key + "'" +
                           (names.empty() ? " (it has none)" : "; it has " + join(names, ", ")));
    }
    if (!entry->assign(value))
      throw ParameterError(std::string(owner) + ": " + key + "=" + to_text(value) + " is not accepted (" +
                           entry->accepts + ")");
  }
}

Json Parameters::values() const {
  Json values = Json::object();
  for (const auto& entry : entries_) values[entry.name] = entry.read();
  return values;
}

std::vector<Parameters::Description> Parameters::describe() const {
  std::vector<Description> all;
  for (const auto& entry : entries_) all.push_back({entry.name, entry.accepts, entry.help, entry.read()});
  return all;
}

}  // namespace rectilin
