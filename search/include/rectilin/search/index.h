// Bringing a database up to what folders hold.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/retrieval/model.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

struct IndexSummary {
  std::size_t unchanged = 0;        ///< were there already, the file's bytes the same
  std::size_t added = 0;            ///< described now, files that were not there
  std::size_t changed = 0;          ///< described again, for the file is another
  std::size_t moved = 0;            ///< the same bytes under another name, the old one gone
  std::size_t copied = 0;           ///< the same bytes as another member: its signature was taken
  std::size_t removed = 0;          ///< members whose files are gone
  std::vector<std::string> errors;  ///< a line for each file that failed now or is known to
  bool complete = false;            ///< false if it was stopped; the same call goes on
};

/// What a signature is made from.
struct DescribedMesh {
  Member member;  ///< all but id, name, source and digest
  Parts parts;
};

/// Describes a mesh by every term; without `seconds`. Throws MeshError.
DescribedMesh describe_model(const retrieval::Model& model, const std::vector<retrieval::DescriptorPointer>& terms);

/// Reads a mesh and describes it. Throws MeshError.
DescribedMesh describe_source(const std::string& source, const std::vector<retrieval::DescriptorPointer>& terms);

/// The terms' descriptors, without weights.
std::vector<retrieval::DescriptorPointer> make_terms(const std::string& descriptor);

/// Makes the database's members what `sources` name: files, folders with all below, archives, lists (see
/// expand_sources()). Members elsewhere, under none of the sources, stay as they are. Several meshes are described at a
/// time; the database is the same for any number of threads, but for seconds. A file that fails becomes a row that says
/// why and is tried again when its bytes change. Progress is over the files that need work.
IndexSummary update_index(Database& database, const std::vector<std::string>& sources, const LoopControl& control = {});

}  // namespace rectilin::search
