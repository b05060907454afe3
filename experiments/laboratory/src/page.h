// The page that shows a comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/laboratory/summary.h"

namespace rectilin::laboratory {

/// A plot on the page: the folder plots/ holds SVG, CSV and gnuplot files of this name.
struct PageImage {
  std::string name, caption;
  int width = 0;  ///< natural width in pixels
};

/// The plots of the page.
struct PagePlots {
  PageImage runtimes, runtimes_seconds, profile, heat;
  struct OfMesh {
    PageImage evaluations, seconds, evaluation_bands, second_bands;
  };
  std::vector<OfMesh> meshes;  ///< only meshes that could be measured, in order
};

/// The text of index.html. `folder` shows which plots could be drawn.
std::string comparison_page(const Results& results, const Summary& summary, const PagePlots& figures,
                            const Json& provenance, const std::filesystem::path& folder);

}  // namespace rectilin::laboratory
