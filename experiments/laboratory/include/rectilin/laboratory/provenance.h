// Where numbers come from: program, libraries, machine, command.
#pragma once

#include <filesystem>
#include <string>

#include "rectilin/laboratory/plan.h"

namespace rectilin::laboratory {

/// Versions of the program and the libraries it was built with, the compiler, the processor, the threads in use,
/// the date (UTC) and the command line.
Json provenance(const std::string& command_line);

/// Adds provenance() to the list `starts` in provenance.json of the folder, beside the plan and every optimizer
/// with all its parameters. The folder is made if need be.
void record_start(const Plan& plan, const Registry& registry, const std::filesystem::path& folder,
                  const std::string& command_line);

}  // namespace rectilin::laboratory
