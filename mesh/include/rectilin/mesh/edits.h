// Changes to a mesh that the measure is said to withstand (paper, section 5.2).
#pragma once

#include <cstddef>

#include "rectilin/base/random.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Moves each coordinate of each vertex by a normal deviate with a standard deviation of `amount`
/// times the largest extent of the vertices' bounding box; so noise does not depend on the mesh's
/// scale. Faces stay together where they share vertices, and come apart where they only touch.
Mesh with_noise(Mesh mesh, double amount, Random random);

/// The mesh without round(fraction * faces) of its faces, 0 <= fraction <= 1, but with one at
/// least. Every choice of that many is equally likely. With the same random numbers a larger
/// fraction takes away the same faces and more. Those that stay keep their order; vertices stay.
Mesh without_faces(const Mesh& mesh, double fraction, Random random);

/// About `faces` triangles that approximate the mesh, by collapsing edges in the order of their
/// quadric error (Garland and Heckbert 1997; the library meshoptimizer). Vertices at one place in
/// single precision become one; those left are where they were. Any soup of triangles will do, but
/// edges are collapsed only where that keeps the surface's topology, so the result can have more
/// faces than asked for: loose triangles cannot be simplified.
Mesh simplified(const Mesh& mesh, std::size_t faces);

/// Length of the longest side of the vertices' bounding box; 0 for a mesh without vertices.
double largest_extent(const Mesh& mesh);

}  // namespace rectilin
