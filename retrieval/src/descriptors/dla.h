#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// dla: depth lines matched by dynamic programming (Chaouch and Verroust-Blondet, ICIP 2007), the method behind a row
/// of the paper's Table 6. From the published description: the model is brought into one pose by continuous principal
/// axes; depth pictures along the axes are taken apart into rows and columns; each becomes a sequence of five kinds of
/// observation (background outside and between, surface level, nearing and receding), and two models are compared by
/// the cost of turning the sequences of the one into those of the other. Chosen here, because it is left open:
///   - six pictures of 32 x 32, drawn so that thin parts are not lost (the row MDLA-DPD has 20 from a dodecahedron);
///   - costs and what counts as level, see depth_lines.h; states move by at most three places;
///   - one pose only, its axes by second moments and pointing to the side with more surface: a picture that is rolled
///     has other rows, so the 24 rotations of gsmd cannot be had by permuting.
void add_dla(DescriptorFactory& factory);

}  // namespace rectilin::retrieval
