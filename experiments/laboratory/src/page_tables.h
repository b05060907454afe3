// The tables of a comparison's page, as HTML, and the sentences that answer its questions.
#pragma once

#include <string>

#include "rectilin/laboratory/summary.h"

namespace rectilin::laboratory {

/// A whole number with commas between thousands.
std::string whole_number(double x);

/// Who stands where after 100, 1,000, ... evaluations, with the winners in words.
std::string standings_html(const Results& results, const Summary& summary);

/// Success rates and expected running times to a choice of targets, over all meshes.
std::string targets_html(const Results& results, const Summary& summary);
/// Expected running times by mesh.
std::string mesh_targets_html(const Results& results, const Summary& summary);

/// On how many meshes is the row's optimizer better than the column's beyond chance?
std::string tests_html(const Results& results, const Summary& summary);

/// What a domain costs: optimizers that ran on several, by domain. Empty if none did.
std::string domains_html(const Results& results, const Summary& summary);

/// How the paper's genetic algorithm fares, and whether R is stable after about 150 generations (its Fig. 6).
/// Empty if it did not run.
std::string genetic_html(const Results& results);

/// Evaluations and time used, with what stands behind the evaluations.
std::string usage_html(const Results& results, const Summary& summary);

/// Certified bounds and the best rotation of each mesh.
std::string meshes_html(const Results& results);

/// Runs that failed and meshes that could not be measured; says so if there are none.
std::string failures_html(const Results& results);

}  // namespace rectilin::laboratory
