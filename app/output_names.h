// Names of what a command writes for each of its sources.
#pragma once

#include <string>
#include <vector>

namespace rectilin::app {

/// For each source the stem of its file or the text of its shape, without characters that shells or file systems
/// dislike. A number is added if an earlier source has the same name, ignoring case.
std::vector<std::string> output_names(const std::vector<std::string>& sources);

}  // namespace rectilin::app
