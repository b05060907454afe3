// What an evaluation leaves in its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/base/parameters.h"
#include "rectilin/evaluation/evaluation.h"
#include "rectilin/report/plot.h"

namespace rectilin::evaluation {

/// matrices/LABEL.matrix and LABEL.models.
void write_result(const std::filesystem::path& out, const Result& result, const retrieval::Classification& classes);

/// Everything else; lines about pictures that could not be drawn.
report::PictureTroubles write_report(const std::filesystem::path& out, const Evaluation& evaluation,
                                     const Json& provenance);

Json summary(const Evaluation& evaluation, const Json& provenance);
std::vector<report::NamedPlot> figures(const Evaluation& evaluation);
std::string page(const Evaluation& evaluation, const std::vector<report::NamedPlot>& plots,
                 const std::filesystem::path& out, const Json& provenance);

/// "descriptor", "matrix" or "lfd_files".
const char* kind_name(Contestant::Kind kind);

/// x in percent with one digit behind the point; a dash if it is not a number.
std::string percent(double x);

}  // namespace rectilin::evaluation
