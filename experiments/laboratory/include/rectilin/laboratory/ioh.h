// Export in the format of IOHprofiler (Doerr et al. 2018; de Nobel et al. 2021), for IOHanalyzer and IOHinspector.
#pragma once

#include <filesystem>

#include "rectilin/laboratory/results.h"

namespace rectilin::laboratory {

/// Writes a folder for each entry that has runs, with
/// - IOHprofiler_f{ID}_{MESH}.json: algorithm, function (the mesh; ID is its place in the plan, from 1), and for each
///   run its instance (from 1), evaluations and best point (Rodrigues vector of the best rotation);
/// - data_f{ID}_{MESH}/IOHprofiler_f{ID}_DIM3.dat: for each run the header `evaluations raw_y` and a line for every
///   improvement. raw_y is the gap, to be minimised, with 17 significant digits. Evaluation 1 and the last are
///   always there: readers tell runs apart by the former.
/// Throws std::runtime_error if that cannot be written.
void export_ioh(const Results& results, const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
