// The tables of a comparison's page as HTML, with the sentences that explain them.
#pragma once

#include <string>

#include "rectilin/laboratory/summary.h"

namespace rectilin::laboratory {

/// A whole number with commas between thousands.
std::string whole_number(double x);

/// The ranking of the entries after 100, 1,000, ... evaluations; names the winners.
std::string standings_html(const Results& results, const Summary& summary);

/// Success rates and expected running times for some of the targets, over all meshes.
std::string targets_html(const Results& results, const Summary& summary);
/// Expected running times by mesh.
std::string mesh_targets_html(const Results& results, const Summary& summary);

/// On how many meshes is the row's optimizer significantly better than the column's?
std::string tests_html(const Results& results, const Summary& summary);

/// What the choice of a domain costs: optimizers that ran on several domains, by domain. Empty if none did.
std::string domains_html(const Results& results, const Summary& summary);

/// How the paper's genetic algorithm does, and whether R is stable after about 150 generations, as its Fig. 6 says.
/// Empty if the algorithm did not run.
std::string genetic_html(const Results& results);

/// Evaluations and times, and what the evaluations consist of.
std::string usage_html(const Results& results, const Summary& summary);

/// Certified bounds and the best known rotation of each mesh.
std::string meshes_html(const Results& results);

/// Runs that failed and meshes that could not be measured; says so if there are none.
std::string failures_html(const Results& results);

}  // namespace rectilin::laboratory
