// The work of update_index() in a worker process.
#pragma once

#include "rectilin/corpus/worker.h"
#include "rectilin/search/describe.h"

namespace rectilin::search {

/// The task that workers are given; its settings are {descriptor}.
inline constexpr const char* kIndexTask = "index";

/// Describes meshes by the descriptor in `settings`. Throws ParameterError for a descriptor that cannot be made.
corpus::Work make_index_work(const Json& settings);

/// What that work answered. Throws std::runtime_error if it is no such answer.
DescribedMesh described_mesh(const corpus::Answer& answer, const std::vector<retrieval::DescriptorPointer>& terms);

}  // namespace rectilin::search
