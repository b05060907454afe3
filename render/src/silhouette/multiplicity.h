// The area where a multiplicity is positive that changes across straight edges: the heart of silhouette areas.
#pragma once

#include <cstdint>
#include <vector>

namespace rectilin::render {

/// An edge across which the multiplicity grows by `jump`, seen from left to right (+x). low_y < high_y.
struct JumpEdge {
  double low_x, low_y, high_x, high_y;
  std::int32_t jump;
};

/// lower <= area <= lower + open + slack in both directions: an estimate with everything that was left out or rounded.
struct CoveredArea {
  double area = 0;   ///< of what is surely covered, up to `slack`
  double open = 0;   ///< of cells that were not settled: covered or not
  double slack = 0;  ///< by how much `area` may be off either way
};

/// The area of the points of positive multiplicity. Left of all edges it is 0, and it is nowhere negative but for what
/// the caller answers for. Stops when the open area is at most `tolerance` times the area.
///
/// All that is used about edges is this: at a height y, moving one edge sideways changes multiplicities only between
/// its old place and its new one. So an edge may be replaced by a nearby one at the price of the area between the two,
/// and nothing here needs exact arithmetic: whatever is rounded is paid for in `slack`.
CoveredArea covered_area(std::vector<JumpEdge> edges, double tolerance);

}  // namespace rectilin::render
