#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// swc: spherical wavelet coefficients of the surface's extent (Laga, Takahashi, Nakajima, SMI 2006), a row of the
/// paper's Table 6. From the published description: a function on the sphere, the distance from the centre to the
/// outermost point in each direction; its spherical wavelet coefficients of the coarse levels; their Euclidean
/// distance. Chosen here, because the description leaves it open or because the house has it:
///   - the sphere is a subdivided octahedron with a sample at each vertex (theirs is a square image folded onto one),
///     and the wavelets are the linear lifted ones of Schroeder and Sweldens;
///   - 258 coefficients of 1026 samples, divided by the sum of their absolute values, 16 bits each (divided by
///     their Euclidean norm they find 5 points of DCG less on the training half of the Princeton Shape Benchmark);
///   - the pose is the rectilinear one and all of its 24 rotations are tried; theirs fixes one pose by principal axes,
///     which `pose=pca-definite&match=one` comes near.
void add_swc(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
