// The page that shows a comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/laboratory/summary.h"

namespace rectilin::laboratory {

/// A picture of the page: SVG, CSV and gnuplot files of this name stand in the folder plots/.
struct PageImage {
  std::string name, caption;
  int width = 0;  ///< natural, in pixels
};

/// What the page is made of besides numbers.
struct PageFigures {
  PageImage runtimes, runtimes_seconds, profile, heat;
  struct OfMesh {
    PageImage evaluations, seconds, evaluation_bands, second_bands;
  };
  std::vector<OfMesh> meshes;  ///< those that could be measured, in order
};

/// index.html as text. `folder` tells which pictures have been drawn.
std::string comparison_page(const Results& results, const Summary& summary, const PageFigures& figures,
                            const Json& provenance, const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
