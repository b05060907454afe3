// A folder of meshes with a classification: which file is which model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/retrieval/classification.h"

namespace rectilin::retrieval {

struct Collection {
  Classification classes;            ///< of the models that have a file
  std::vector<std::string> files;    ///< of each of those models, for load_mesh()
  std::vector<std::string> missing;  ///< models without a file, in the classification's order
};

/// Finds the mesh file of each model in a folder and below: NAME.off or mNAME.off, as the Princeton Shape Benchmark has
/// it, of any format that read_mesh() knows. Throws std::runtime_error if two files could be the same model, or if
/// there is no mesh file at all.
Collection find_collection(const std::filesystem::path& folder, const Classification& classes);

/// Names of the classes that have no models of their own and no class below them that has.
std::vector<std::string> empty_classes(const Classification& classes);

}  // namespace rectilin::retrieval
