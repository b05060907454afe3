// Everything that is derived from the runs of a comparison.
#pragma once

#include <filesystem>

#include "rectilin/base/folder_lock.h"
#include "rectilin/report/plot.h"

namespace rectilin {

/// Writes into the folder of a comparison (see run_comparison()), from what it holds and nothing else:
/// index.html, summary.json, runs.csv, meshes.csv, ert.csv, tests.csv, ioh/ and plots/. Without gnuplot there are no
/// pictures, and the rest is written all the same. Nobody else writes there meanwhile. Throws std::runtime_error if the
/// folder holds no comparison, cannot be written or another program is writing there.
PictureTroubles write_report(const std::filesystem::path& folder);

/// The same for who holds the folder already.
PictureTroubles write_report(const std::filesystem::path& folder, const FolderLock& held);

}  // namespace rectilin
