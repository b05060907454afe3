// The outline from which the light field descriptor's own program takes its Fourier coefficients.
#pragma once

#include <vector>

#include "features/contour.h"

namespace rectilin::retrieval {

/// The boundary that its program walks along, version 1.8 (Chen, Tian, Shen, Ouhyoung 2003). It differs from
/// outer_contour() in all that the numbers depend on:
///   - it begins at the first pixel of the lowest row, so it is the outline of the lowest part, not of the largest;
///   - it goes round by Pavlidis's rule (Algorithms for Graphics and Image Processing, 1982, section 7.5), which cuts
///     some corners, and has its first pixel at its end again;
///   - if it encloses no more than 95 % of the silhouette, the silhouette is first grown by a square of 3 x 3 pixels,
///     if that is not enough also by one of 5 x 5 without corners, and if even that is not enough replaced by its
///     bounding box; what was added is then peeled off again as far as that parts nothing (see thinned_to()).
/// Empty for an empty picture, for a lone pixel and for outlines of less than eight pixels.
std::vector<Pixel> ntu_contour(const Mask& silhouette);

/// Takes pixels of `grown` away that `kept` has not, from below, above, left and right in turn, all of one side at
/// once, until nothing changes. A pixel may go if its covered neighbours hang together by their sides about it and
/// there is not exactly one of them.
Mask thinned_to(Mask grown, const Mask& kept);

}  // namespace rectilin::retrieval
