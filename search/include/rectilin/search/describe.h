// From a mesh to what a database keeps of it.
#pragma once

#include <string>
#include <vector>

#include "rectilin/retrieval/model.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

/// What a signature is made from.
struct DescribedMesh {
  Member member;  ///< all but id, name, source and digest
  Parts parts;
};

/// Describes a mesh by every term. Throws MeshError.
DescribedMesh describe_model(const retrieval::Model& model, const std::vector<retrieval::DescriptorPointer>& terms);

/// Reads a mesh and describes it.
DescribedMesh describe_source(const std::string& source, const std::vector<retrieval::DescriptorPointer>& terms);

/// The terms' descriptors, without weights.
std::vector<retrieval::DescriptorPointer> make_terms(const std::string& descriptor);

}  // namespace rectilin::search
