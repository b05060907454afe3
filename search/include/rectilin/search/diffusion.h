// Ranking by the shape of the collection: what lies between two shapes makes them alike.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rectilin/search/nearest.h"

namespace rectilin::search {

struct DiffusionOptions {
  std::size_t pool = 400;      ///< members nearest to the query that are ranked anew
  std::size_t neighbours = 3;  ///< of each shape in the pool that it is linked to
  double spread = 0.95;        ///< share of the activation that goes on at each step: 0 to below 1
  int steps = 100;
  double straight = 3;  ///< how much the distance itself counts, see diffused_nearest()
};

/// Manifold ranking (Zhou et al. 2004) on a graph of neighbours with scales of their own (Zelnik-Manor and Perona
/// 2005). `distances` is a symmetric matrix of `size` rows, the query the first of them. Links have the weight exp(-d^2
/// / (s_i s_j)), s the distance to the last of a shape's neighbours; f = spread S f + (1 - spread) e_query is iterated
/// with the symmetrically normalised weights S. Returns f over the root of each shape's weight, the query's own as it
/// is: how much of the query's activation each gets, without the advantage of those that are linked to many.
std::vector<double> diffuse(std::span<const float> distances, std::size_t size, const DiffusionOptions& options = {});

/// The n members most like the query by diffusion within its pool; members are compared with each other without labels.
/// Distances are -log(f / f(query)) + straight * d / s, d the distance from the query and s that of the last of its
/// neighbours: from 0 on, on a scale of their own. The cost beyond the search does not depend on the collection's size.
/// Deterministic.
std::vector<Neighbour> diffused_nearest(const NearestSearch& search, const Parts& query, std::size_t n,
                                        const std::function<bool(std::size_t)>& keep = {},
                                        const DiffusionOptions& options = {});

}  // namespace rectilin::search
