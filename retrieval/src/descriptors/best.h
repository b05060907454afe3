// The descriptor to take if one has no reason for another.
#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

void add_best(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
