// What is to be evaluated, as typed.
#include <cctype>
#include <set>

#include "rectilin/evaluation/evaluation.h"
#include "rectilin/evaluation/weights.h"
#include "rectilin/laboratory/plan.h"

namespace rectilin::evaluation {
namespace {

/// At blanks, and at commas that no number follows.
std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> items(1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto c = static_cast<unsigned char>(list[i]);
    const auto next = static_cast<unsigned char>(i + 1 < list.size() ? list[i + 1] : ' ');
    const bool in_value = items.back().find('?') != std::string::npos && (std::isdigit(next) != 0 || next == '-');
    if (std::isspace(c) != 0 || (c == ',' && !in_value)) items.emplace_back();
    else items.back() += static_cast<char>(c);
  }
  std::erase(items, "");
  return items;
}

/// `LABEL=` before anything that belongs to the descriptor itself.
laboratory::LabelledSpec split_composite_label(std::string_view text) {
  const std::size_t equals = text.find('='), inside = text.find_first_of("?*+");
  if (equals == std::string_view::npos || inside < equals) return {text, text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void check_labels(const std::vector<Contestant>& contestants) {
  std::set<std::string> seen;
  for (const Contestant& c : contestants) {
    if (c.label.empty()) throw ParameterError("'" + c.text + "' has an empty label");
    if (!seen.insert(c.label).second)
      throw ParameterError("'" + c.label + "' is there twice; LABEL= in front gives one of them another name");
  }
}

}  // namespace

std::vector<Contestant> parse_contestants(const std::vector<std::string>& lists) {
  std::vector<Contestant> contestants;
  for (const std::string& list : lists)
    for (const std::string& item : split(list)) {
      const laboratory::LabelledSpec labelled = split_composite_label(item);
      Contestant c{std::string(labelled.label), std::string(labelled.spec)};
      if (c.text.starts_with('@')) c.text = read_weights(c.text.substr(1));
      retrieval::make_descriptor(c.text);  // an error now rather than after an hour
      contestants.push_back(std::move(c));
    }
  check_labels(contestants);
  return contestants;
}

void add_foreign(std::vector<Contestant>& contestants, const std::vector<std::string>& files, Contestant::Kind kind) {
  for (const std::string& text : files) {
    const std::size_t equals = text.find('=');
    const std::string file = equals == std::string::npos ? text : text.substr(equals + 1);
    const std::string label = equals == std::string::npos
                                  ? (std::filesystem::path(file) / "").parent_path().stem().string()
                                  : text.substr(0, equals);
    contestants.push_back({label, file, kind});
  }
  check_labels(contestants);
}

}  // namespace rectilin::evaluation
