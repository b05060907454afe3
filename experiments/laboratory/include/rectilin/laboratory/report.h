// Everything that is derived from the runs of a comparison.
#pragma once

#include <filesystem>

#include "rectilin/report/plot.h"

namespace rectilin::laboratory {

/// Writes into the folder of a comparison (see run_comparison()), from what it holds and nothing else:
/// index.html, summary.json, runs.csv, meshes.csv, ert.csv, tests.csv, ioh/ and plots/. Without gnuplot there are no
/// pictures, and the rest is written all the same. Nobody else writes there meanwhile. Throws std::runtime_error if the
/// folder holds no comparison, cannot be written or another program is writing there.
report::PictureTroubles write_report(const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
