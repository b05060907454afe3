// Signatures of `lfd:ntu` as the four files that the light field descriptor's own program writes for a model.
#pragma once

#include <filesystem>

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// Writes BASE.art (3500 bytes), BASE.fd (1000), BASE.cir (100) and BASE.ecc (100), each indexed [light field][camera]
/// [coefficient]; a base of `models/m1` gives models/m1.art and so on. Their program for comparing models reads them.
/// Throws std::invalid_argument for a signature of another length, std::runtime_error if a file cannot be written.
void write_lfd_files(const std::filesystem::path& base, SignatureView signature);

/// Reads what that program, or write_lfd_files(), wrote. Throws std::runtime_error, one line with the file's name, if
/// one of the four cannot be read or has another length.
Signature read_lfd_files(const std::filesystem::path& base);

}  // namespace rectilin::retrieval
