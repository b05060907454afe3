// The report of a comparison: everything that follows from its runs.
#pragma once

#include <filesystem>

#include "rectilin/base/folder_lock.h"
#include "rectilin/report/plot.h"

namespace rectilin::laboratory {

/// Writes index.html, summary.json, runs.csv, meshes.csv, ert.csv, tests.csv, ioh/ and plots/ into the folder of a
/// comparison (see run_comparison()), from what that folder holds and nothing else. Without gnuplot the plots are
/// missing, and everything else is written all the same. Throws std::runtime_error if the folder holds no comparison,
/// cannot be written, or if another program is writing there.
report::PictureTroubles write_report(const std::filesystem::path& folder);

/// Likewise, for a caller that holds the lock of the folder already.
report::PictureTroubles write_report(const std::filesystem::path& folder, const FolderLock& held);

}  // namespace rectilin::laboratory
