#include "rectilin/optim/registry.h"

#include "core/pipeline.h"

namespace rectilin {
namespace {

std::vector<std::string> split_stages(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::vector<std::string> stages(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '+' && i + 1 < text.size() && is_letter(text[i + 1])) stages.emplace_back();
    else stages.back() += text[i];
  }
  return stages;
}

std::unique_ptr<Optimizer> in_a_row(std::vector<std::unique_ptr<const Optimizer>> stages) {
  return std::make_unique<Pipeline>(std::move(stages));
}

}  // namespace

std::unique_ptr<Optimizer> Registry::make(std::string_view text) const {
  const std::vector<std::string> specs = split_stages(text);
  if (specs.size() == 1) {
    const Spec spec = Spec::parse(text);
    return make(spec.name, spec.settings);
  }
  std::vector<std::unique_ptr<const Optimizer>> stages;
  for (const std::string& spec : specs) stages.push_back(make(spec));
  return in_a_row(std::move(stages));
}

std::unique_ptr<Optimizer> Registry::make(std::string_view name, const Json& settings) const {
  const std::vector<std::string> names = split_stages(name);
  if (names.size() > 1) {
    if (!settings.is_array() || settings.size() != names.size())
      throw ParameterError(std::string(name) + ": its settings must be an array with one object for each stage");
    std::vector<std::unique_ptr<const Optimizer>> stages;
    for (std::size_t i = 0; i < names.size(); ++i) stages.push_back(make(names[i], settings[i]));
    return in_a_row(std::move(stages));
  }
  return table_.find(name).make(settings, *this);
}

}  // namespace rectilin
