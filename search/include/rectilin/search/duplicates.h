// Files of one shape: copies in other formats, poses, sizes and tessellations.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/search/database.h"
#include "rectilin/search/overlay.h"

namespace rectilin::search {

struct DuplicateOptions {
  std::size_t neighbours = 10;  ///< of each member so many are looked at more closely
  double widest = 0.6;          ///< and of these those that are no further by the descriptor; in typical distances
  double tolerance = 0.015;     ///< largest distance of the surfaces, root mean square, in radii of the shape
  double shared = 0.8;          ///< or this share of the coarser mesh's vertices, 16 at least, are the other's, and
  double loose = 0.2;           ///< the surfaces are no further apart than this: a simplified copy
  /// Neighbours are found by the graph in this file, see open_approximate(); if empty, exactly, which takes a time that
  /// grows with the square of the number of members.
  std::filesystem::path graph = {};
};

/// How a pair was found to be one shape. The second mesh is turned, scaled and moved onto the first, and mirrored if
/// that is what it takes.
struct DuplicateEvidence {
  std::size_t first, second;   ///< members
  double descriptor_distance;  ///< by the database's descriptor
  double surface_distance;     ///< root mean square over both surfaces, in radii (root mean square from the centre)
  double shared_vertices;      ///< share of the coarser mesh's vertices that are the other's, within 0.001 radii
  bool mirrored;               ///< a mirror image: after a reflection the surfaces are less than half as far apart
  bool same_bytes;             ///< the files are the same
  double scale;                ///< size of the second over that of the first
  Placement placement;         ///< takes the second file's coordinates to the first's
};

struct DuplicateGroup {
  std::vector<std::size_t> members;         ///< in order
  std::vector<bool> mirrored;               ///< of each, whether it is a mirror image of the first
  std::vector<DuplicateEvidence> evidence;  ///< pairs that hold it together, each member but the first once
};

struct Duplicates {
  std::vector<Member> members;         ///< of the database that are done, in the order of their names
  std::vector<DuplicateGroup> groups;  ///< in the order of their first members
  std::vector<std::string> errors;     ///< of files that could not be read any more
  std::string note;                    ///< what was amiss with the graph, if anything
  std::size_t pairs_looked_at = 0;
  bool complete = false;
};

/// Finds them: neighbours by descriptor are brought onto each other, by their principal axes and by the frames of their
/// largest rectilinearity in all 24 rotations with and without a reflection, the fit refined; what is left between the
/// surfaces decides, or that vertices of the coarser mesh are vertices of the finer one, as a simplified copy's are.
/// Of files with the same bytes one is compared. Reads the files of candidates; nothing is changed or removed. The
/// result does not depend on the number of threads.
Duplicates find_duplicates(Database& database, const DuplicateOptions& options = {}, const LoopControl& control = {});

}  // namespace rectilin::search
