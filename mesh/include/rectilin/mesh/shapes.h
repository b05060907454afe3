// Shapes the program makes itself: test objects with known answers, and meshes of any size.
#pragma once

#include "rectilin/base/factory.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Makes the shape of a spec such as `sphere?subdivisions=4&rotate=random&seed=7` (the text after
/// `shape:`). Every shape accepts, besides its own parameters, the common ones `rotate`, `noise`,
/// `scale` and `seed`. Solids are closed, oriented outward and without triangles of zero area
/// (before noise and apart from rounding). Same spec, same mesh, bit for bit. Time and memory grow
/// like the number of faces, at most 2^25. Throws ParameterError for an unknown shape or setting.
/// Thread safe.
Mesh make_shape(const Spec& spec);

/// Every shape there is. A new one is a struct in mesh/src/shapes with `bind` and `build`, and one line in shapes.cpp.
const Factory<Mesh>& shape_table();

}  // namespace rectilin
