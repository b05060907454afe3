// Tables of things that are made from text, such as `ga?population=100`: optimizers, shapes, poses, views, descriptors.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rectilin/base/parameters.h"

namespace rectilin {

/// Throws the ParameterError for an unknown name: "no KIND 'NAME'; did you mean 'NEAREST'? There are ...". A nearest
/// name is suggested only if it is a few typing errors away.
[[noreturn]] void throw_unknown_name(std::string_view kind, std::string_view name,
                                     const std::vector<std::string>& known);

/// A table of things that can be made from a name and settings, written `NAME?key=value&key=value` (see Spec).
///
/// Each entry has an options struct, whose member `bind(Parameters&)` names its fields, and a function that makes a T
/// from such options and from whatever else the caller passes to make() (`Context`):
///
///     Factory<Mesh> shapes("shape");
///     shapes.add("box", "a cuboid", BoxOptions(), make_box);       // Mesh make_box(const BoxOptions&)
///     const Mesh mesh = shapes.make("box?x=2");
///
/// A value type: copy a table and add entries of your own. Const members are thread safe.
template <class T, class... Context>
class Factory {
 public:
  struct Entry {
    std::string name, help;
    std::vector<Parameters::Description> parameters;  ///< the settings it accepts, with their defaults
    std::function<T(const Json& settings, Context... context)> make;
  };

  /// `kind` names an entry in error messages, in the singular: "shape", "optimizer".
  explicit Factory(std::string kind) : kind_(std::move(kind)) {}

  /// `maker(options, context...)` makes the thing; its options are `defaults` with the user's settings applied.
  template <class Options, class Maker>
  Factory& add(std::string name, std::string help, Options defaults, Maker maker) {
    return add(entry(std::move(name), std::move(help), std::move(defaults), std::move(maker)));
  }

  /// Builds such an entry without adding it to a table.
  template <class Options, class Maker>
  static Entry entry(std::string name, std::string help, Options defaults, Maker maker) {
    Options shown = defaults;
    Parameters table;
    shown.bind(table);
    auto from_settings = [name, defaults, maker](const Json& settings, Context... context) -> T {
      Options options = defaults;
      Parameters fields;
      options.bind(fields);
      fields.set(settings, name);
      return maker(std::move(options), context...);
    };
    return {std::move(name), std::move(help), table.describe(), std::move(from_settings)};
  }

  Factory& add(Entry entry) {
    entries_.push_back(std::move(entry));
    return *this;
  }

  /// Throws ParameterError for an unknown name or a setting that is not accepted.
  T make(std::string_view text, Context... context) const {
    const Spec spec = Spec::parse(text);
    return find(spec.name).make(spec.settings, context...);
  }

  /// Throws ParameterError for an unknown name.
  const Entry& find(std::string_view name) const {
    const auto entry = std::ranges::find(entries_, name, &Entry::name);
    if (entry == entries_.end()) {
      std::vector<std::string> known;
      for (const Entry& e : entries_) known.push_back(e.name);
      throw_unknown_name(kind_, name, known);
    }
    return *entry;
  }

  /// In the order they were added.
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::string kind_;
  std::vector<Entry> entries_;
};

}  // namespace rectilin
