// Signatures of a whole collection, kept in files so that nothing is computed twice.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/retrieval/collection.h"
#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// All signatures of one descriptor, in the order of the collection's models.
struct FeatureTable {
  std::vector<Signature> signatures;  ///< empty for a model that failed
  double seconds = 0;                 ///< processor time of a thread for a model, mean; poses that several descriptors
                                      ///< share count for the one that asked first
};

struct Features {
  std::map<std::string, FeatureTable> tables;  ///< by the descriptor's text
  std::vector<std::string> failed;             ///< models, in order
  std::vector<std::string> errors;             ///< a line for each of them
  std::vector<std::string> losses;             ///< a line for each mesh that is not all that its file holds
  bool complete = false;                       ///< false if it was stopped
};

/// Describes every model by every one of `specs` (texts for descriptors().make(), without repetition), several models
/// at a time. What `folder` (made if need be) holds of an earlier run is taken from there: a file for each descriptor,
/// named by all its settings, with a line for each model that says from which bytes it was made. The result does not
/// depend on the number of threads. Throws std::runtime_error if the folder cannot be written.
Features compute_features(const Collection& collection, const std::vector<std::string>& specs,
                          const std::filesystem::path& folder, const LoopControl& control = {});

/// The descriptor's name with all its settings, also those that are at their defaults.
std::string full_spec(const std::string& spec);

}  // namespace rectilin::retrieval
