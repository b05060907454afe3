// The plots of a comparison.
#pragma once

#include <string>
#include <vector>

#include "rectilin/laboratory/summary.h"
#include "rectilin/report/plot.h"

namespace rectilin::laboratory {

/// The line style of every entry: a colour for each optimizer, dashes for its domains.
std::vector<report::LineStyle> styles(const Plan& plan);

/// Gap against cost on one mesh: the medians of all entries in one plot.
report::NamedPlot convergence_plot(const Results& results, std::size_t mesh, Cost unit);
/// The same with a panel for each entry and a band from the 10 % to the 90 % quantile.
report::NamedPlot band_plot(const Results& results, std::size_t mesh, Cost unit);

/// Empirical distribution of runtimes: the share of all pairs of a run and a target that were reached within a cost,
/// over all meshes and targets() (Hansen et al. 2021).
report::NamedPlot runtime_plot(const Results& results, Cost unit);

/// Performance profile (Dolan and More 2002): for what share of the problems, pairs of a mesh and a target, is the
/// expected running time within a factor of the best optimizer's?
report::NamedPlot profile_plot(const Results& results, const Summary& summary);

/// log10 of the median final gap: a table of entries by meshes.
report::NamedPlot heat_plot(const Results& results, const Summary& summary);

/// Makes text fit for a file name: only letters of any script (in UTF-8), digits and dashes, at most 120 bytes.
std::string slug(const std::string& text);
/// The same for several texts, each result different from the others.
std::vector<std::string> unique_slugs(const std::vector<std::string>& texts);

}  // namespace rectilin::laboratory
