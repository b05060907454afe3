#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// r: the paper's measure as a descriptor of one number.
void add_rectilinearity(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
