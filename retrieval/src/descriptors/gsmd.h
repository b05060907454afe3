#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// gsmd: the paper's geodesic sphere based multi-view descriptor.
void add_gsmd(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
