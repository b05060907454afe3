// A mesh that has been read, described.
#pragma once

#include "rectilin/search/index.h"

namespace rectilin::search {

DescribedMesh describe_mesh(Mesh mesh, const std::vector<retrieval::DescriptorPointer>& terms);

}  // namespace rectilin::search
