// Progress of an index, read from its database.
#pragma once

#include <filesystem>

#include "rectilin/corpus/status.h"

namespace rectilin::search {

/// The status of a database of shapes as that of a store; nothing is `limited` in one. There is no rate unless the
/// index goes on. Throws std::runtime_error as Database does. The database may be in use.
corpus::StoreStatus status_of(const std::filesystem::path& database);

}  // namespace rectilin::search
