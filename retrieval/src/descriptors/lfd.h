#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// lfd, lfd:ntu: the light field descriptor as the paper has it, and as its authors' program does.
void add_lfd(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
