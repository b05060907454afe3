// The box of least volume round a mesh.
//
// O'Rourke (1985) finds it exactly in cubic time. Here each of many frames is improved by turning it about its own axes
// in turn until that gains nothing, each time to the exact best: the rectangle of least area round the projection, one
// of whose sides lies along an edge of the projection's outline (Freeman and Shapira 1975). Chang, Gorissen and Melchior
// (2011) found such a descent from few starts to end at the optimum nearly always.
#include <algorithm>
#include <cmath>
#include <limits>

#include "../../optim/src/search/super_fibonacci.h"
#include "frames.h"
#include "methods.h"
#include "rectilin/pose/convex_hull.h"

namespace rectilin::pose {
namespace {

struct Box {
  Rotation rotation;
  double volume = std::numeric_limits<double>::infinity();
};
