// How far a surface reaches, in bytes.
#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

void add_extents(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
