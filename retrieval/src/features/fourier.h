// Fourier descriptors of outlines.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "features/contour.h"

namespace rectilin::retrieval {

/// Distances of an outline's pixels from a centre, in the outline's order.
std::vector<double> centroid_distances(std::span<const Pixel> contour, double x, double y);

/// |C_k| / |C_0| for k = 1 ... count, C the discrete Fourier transform of the values; zeros if C_0 is. They do not
/// depend on where the outline begins and which way it goes round (Zhang and Lu 2002).
std::vector<double> fourier_descriptors(std::span<const double> values, int count);

}  // namespace rectilin::retrieval
