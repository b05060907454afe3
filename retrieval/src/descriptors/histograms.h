#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// d1, d2, aad, sprh: histograms over points of the surface and pairs of them.
void add_histograms(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
