// The descriptor of views with more than their outline's shape.
#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

void add_views(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
