// Built-in shapes: test objects whose R is known, and meshes of any size.
#pragma once

#include "rectilin/base/factory.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Makes the shape that a text such as `sphere?subdivisions=4&rotate=random&seed=7` describes (what follows `shape:` in
/// a source). Besides its own parameters every shape accepts `rotate`, `noise`, `scale` and `seed`. Solids are closed,
/// oriented outward and free of triangles without area (before noise, and apart from rounding). The same text gives the
/// same mesh, bit for bit. Time and memory grow with the number of faces, which is at most 2^25. Throws ParameterError
/// for an unknown shape or setting. Thread safe.
Mesh make_shape(const Spec& spec);

/// All built-in shapes. A new one is a struct with `bind` and `build` in mesh/src/shapes, and one line in shapes.cpp.
const Factory<Mesh>& shape_table();

}  // namespace rectilin
