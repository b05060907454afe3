// The chair-like test model of Fig. 12.
#pragma once

#include "rectilin/mesh/mesh.h"

namespace rectilin::paper::figures {

struct ChairOptions {
  int slats = 0;            ///< of the back, with gaps between them; 0: one solid board
  bool stretchers = false;  ///< bars between the legs
  int faces = 20'000;       ///< triangles in all, about
};

/// A seat on four round legs with a back that leans backwards, about 1 high. Its parts are closed
/// surfaces that overlap a little where they meet, as in most models made by hand.
Mesh chair(const ChairOptions& options);

}  // namespace rectilin::paper::figures
