// The rows of Tables 2 to 6: descriptors, and the paper's numbers for them.
#pragma once

#include <vector>

#include "tables/retrieval_table.h"

namespace rectilin::paper::tables {

/// Silhouettes from 6 to 258 views, and LFD. As in the paper the pose is CPN; the last row is the best rectilinear pose
/// alone, for comparison.
std::vector<Row> table2_rows();

/// GSMD_66 of silhouettes in the poses by CPN and by principal axes, matched in 24, 4 and 1 ways.
std::vector<Row> table3_rows();

/// Each descriptor without R, and in the same order with R. GSMD is of depths.
std::vector<Row> table4_rows();
std::vector<Row> table5_rows();

/// The best sum, and other methods, some of which are built in and some only cited.
std::vector<Row> table6_rows();

}  // namespace rectilin::paper::tables
