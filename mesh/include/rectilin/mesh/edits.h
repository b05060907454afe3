// Changes to a mesh that R is said to withstand: noise, deleted faces, simplification (paper, section 5.2).
#pragma once

#include <cstddef>

#include "rectilin/base/random.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Adds normal noise to every coordinate of every vertex, with a standard deviation of `amount` times the longest side
/// of the bounding box, so that the effect does not depend on the mesh's scale. Faces that share a vertex stay
/// connected; faces that only touch, each with vertices of its own, come apart.
Mesh with_noise(Mesh mesh, double amount, Random random);

/// The mesh without round(fraction * faces) of its faces, chosen at random, 0 <= fraction <= 1; at least one face is
/// kept. Every choice of that many faces is equally likely. With the same random numbers a larger fraction deletes the
/// same faces and more. The remaining faces keep their order; all vertices stay.
Mesh without_faces(const Mesh& mesh, double fraction, Random random);

/// Approximates the mesh by about `faces` triangles, by collapsing edges in the order of their quadric error
/// (Garland and Heckbert 1997; the library meshoptimizer). Vertices that agree in single precision become one; the
/// vertices that are left have not moved. Any soup of triangles is accepted, but edges are collapsed only where that
/// keeps the topology of the surface, so the result can have more faces than asked for: loose triangles cannot be
/// simplified at all.
Mesh simplified(const Mesh& mesh, std::size_t faces);

/// Length of the longest side of the vertices' bounding box; 0 for a mesh without vertices.
double largest_extent(const Mesh& mesh);

}  // namespace rectilin
