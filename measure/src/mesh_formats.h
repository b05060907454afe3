// Which format a file name stands for.
#pragma once

#include <filesystem>
#include <optional>

#include "rectilin/measure/mesh_io.h"

namespace rectilin {

/// The format of a file by its extension, in any case; none if that is not one of ours.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file);

}  // namespace rectilin
