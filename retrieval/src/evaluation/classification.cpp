#include "rectilin/retrieval/classification.h"

#include <charconv>
#include <stdexcept>
#include <unordered_map>

#include "rectilin/base/whole_file.h"

namespace rectilin::retrieval {
namespace {

/// Words of a text, and in which line the last one stands.
class WordReader {
 public:
  WordReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  bool at_end() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n';
    return at_ == text_.size();
  }

  std::string_view next(const char* what) {
    if (at_end()) fail(std::string("the file ends where ") + what + " should be");
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::size_t count(const char* what) {
    const std::string_view word = next(what);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      fail("'" + std::string(word) + "' stands where " + what + " should be");
    return value;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(name_ + ":line " + std::to_string(line_) + ": " + reason);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

std::string Classification::path(std::size_t c) const {
  const Class& own = classes[c];
  return own.parent ? path(*own.parent) + "/" + own.name : own.name;
}

Classification Classification::subset(const std::vector<bool>& keep) const {
  Classification kept;
  for (const Class& c : classes) kept.classes.push_back({c.name, c.parent, {}});
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!keep[i]) continue;
    kept.classes[class_of[i]].models.push_back(kept.models.size());
    kept.class_of.push_back(class_of[i]);
    kept.models.push_back(models[i]);
  }
  return kept;
}

Classification parse_classification(std::string_view text, const std::string& name) {
  WordReader words(text, name);
  if (words.next("'PSB'") != "PSB") words.fail("not a classification: it does not begin with 'PSB 1'");
  if (words.next("the version") != "1") words.fail("only version 1 is known");
  const std::size_t classes = words.count("the number of classes");
  const std::size_t models = words.count("the number of models");

  Classification result;
  std::unordered_map<std::string, std::size_t> class_number, class_of_model;
  for (std::size_t c = 0; c < classes; ++c) {
    const std::string own(words.next("the name of a class"));
    if (!class_number.emplace(own, c).second) words.fail("class '" + own + "' is there twice");
    const std::string parent(words.next("the name of a parent"));
    Classification::Class& added = result.classes.emplace_back();
    added.name = own;
    if (parent != "0") {
      const auto found = class_number.find(parent);
      if (found == class_number.end() || found->second == c)
        words.fail("class '" + own + "': no earlier class is called '" + parent + "'");
      added.parent = found->second;
    }
    const std::size_t members = words.count("the number of a class's models");
    for (std::size_t m = 0; m < members; ++m) {
      const std::string model(words.next("a model"));
      const auto [entry, is_new] = class_of_model.emplace(model, c);
      if (!is_new)
        words.fail("model '" + model + "' is there twice, in '" + result.classes[entry->second].name + "' and in '" +
                   own + "'");
      added.models.push_back(result.models.size());
      result.models.push_back(model);
      result.class_of.push_back(c);
    }
  }
  if (!words.at_end()) words.fail("there is more than the " + std::to_string(classes) + " classes announced");
  if (result.models.size() != models)
    words.fail("there are " + std::to_string(result.models.size()) + " models, " + std::to_string(models) +
               " are announced");
  return result;
}

Classification read_classification(const std::filesystem::path& file) {
  return parse_classification(read_whole_file(file), file.string());
}

}  // namespace rectilin::retrieval
