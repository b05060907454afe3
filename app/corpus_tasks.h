// What worker processes do for the tasks of the commands.
#pragma once

#include <optional>

#include "rectilin/corpus/worker.h"

namespace rectilin::app {

/// Throws ParameterError if there is no such task.
corpus::Work make_work(const corpus::Task& task, std::optional<double> seconds);

}  // namespace rectilin::app
