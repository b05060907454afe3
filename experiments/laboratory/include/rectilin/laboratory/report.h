// Everything that is derived from the runs of a comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rectilin {

/// Writes into the folder of a comparison (see run_comparison()), from what it holds and nothing else:
/// index.html, summary.json, runs.csv, meshes.csv, ert.csv, tests.csv, ioh/ and plots/. Returns a line for
/// each kind of trouble with pictures: without gnuplot there are none, and the rest is written all the same.
/// Throws std::runtime_error if the folder holds no comparison or cannot be written.
std::vector<std::string> write_report(const std::filesystem::path& folder);

}  // namespace rectilin
