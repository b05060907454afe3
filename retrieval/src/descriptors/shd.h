#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// shd: spherical harmonics of the surface's extent, about each axis of the pose.
void add_shd(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
