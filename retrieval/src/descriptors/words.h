// The descriptor of local features on depth pictures.
#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

void add_words(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
