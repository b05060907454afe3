// Which model belongs to which class: the `.cla` files of the Princeton Shape Benchmark.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rectilin::retrieval {

/// A tree of classes over models, after Shilane, Min, Kazhdan and Funkhouser (2004). Models are numbered in the order
/// of the file, which is the order of the rows of every distance matrix; each belongs to one class.
///
/// The file is text, words separated by white space: `PSB 1`, then the numbers of classes and of models, then for each
/// class its name, its parent's name (`0` for none), its number of models, and that many models.
struct Classification {
  struct Class {
    std::string name;
    std::optional<std::size_t> parent;  ///< an earlier class
    std::vector<std::size_t> models;    ///< its own, without those of its children; may be empty
  };
  std::vector<Class> classes;         ///< in the order of the file
  std::vector<std::string> models;    ///< names, in the order of the file; all different
  std::vector<std::size_t> class_of;  ///< of each model

  /// Name with those of its ancestors before it, as "animal/biped/human".
  std::string path(std::size_t c) const;

  /// The models for which `keep` is true, in the same order and with all classes, some of which may become empty.
  Classification subset(const std::vector<bool>& keep) const;
};

/// Throws std::runtime_error, "FILE:line N: reason", for a file that is not one, a class or model named twice, a parent
/// that no earlier class is called, and counts that disagree with what is there.
Classification read_classification(const std::filesystem::path& file);

/// The same from text in memory; `name` stands for the file in errors.
Classification parse_classification(std::string_view text, const std::string& name);

}  // namespace rectilin::retrieval
