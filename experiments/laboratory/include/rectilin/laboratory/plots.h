// The figures of a comparison.
#pragma once

#include <string>
#include <vector>

#include "rectilin/laboratory/summary.h"
#include "rectilin/report/plot.h"

namespace rectilin::laboratory {

/// Line style of every entry: a colour for each optimizer, a dash for each of its domains.
std::vector<report::LineStyle> styles(const Plan& plan);

/// Gap against cost on one mesh: medians of all entries in one picture.
report::NamedPlot convergence_plot(const Results& results, std::size_t mesh, Cost unit);
/// The same, a panel for each entry, with the band from the 10 % to the 90 % quantile.
report::NamedPlot band_plot(const Results& results, std::size_t mesh, Cost unit);

/// Empirical distribution of runtimes: the share of pairs (run, target) reached within a cost, over all meshes
/// and targets() (Hansen et al. 2021).
report::NamedPlot runtime_plot(const Results& results, Cost unit);

/// Performance profile (Dolan and More 2002): for what share of the problems, pairs (mesh, target), is the
/// expected running time within a factor of the best one's?
report::NamedPlot profile_plot(const Results& results, const Summary& summary);

/// log10 of the median final gap, entries by meshes.
report::NamedPlot heat_plot(const Results& results, const Summary& summary);

/// Letters of any script (in UTF-8), digits and dashes only, at most 120 bytes, to be part of a file name.
std::string slug(const std::string& text);
/// The same for many, each different from the others.
std::vector<std::string> unique_slugs(const std::vector<std::string>& texts);

}  // namespace rectilin::laboratory
