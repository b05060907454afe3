// Exports a store as a table for other programs.
#pragma once

#include <filesystem>

#include "rectilin/corpus/store.h"

namespace rectilin::corpus {

/// Writes the store's rows, in the order of their names, in the format of the file's extension:
///
///     .csv    name, class, status, digest, faces, area, FIELDS, seconds, version, error
///     .jsonl  one JSON object a line: name, source, class, status, digest, the members of the result, report, seconds,
///             version, error
///     .npy    a structured array for numpy.load(file): name and class (bytes), status (1 limited, 2 failed, 3 done),
///             faces, area, the FIELDS that are numbers, seconds, rotation (3 by 3), of poses also centre (3); NaN, or
///             -1 for faces, where there is no result
///
/// FIELDS are, of the task
///
///     measure  rectilinearity, lower, upper
///     pose     chosen, uniqueness, scale, confidence
///     compare  outcome, merit, evaluations
///
/// Meshes that are still to be done are left out. Numbers keep every bit. Memory use does not grow with the store.
/// Throws ParameterError for another extension, std::runtime_error if the file cannot be written.
void export_store(Store& store, const std::filesystem::path& file);

}  // namespace rectilin::corpus
