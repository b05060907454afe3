// Ranking by the shape of the collection: what lies between two shapes makes them alike.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rectilin/retrieval/distance_matrix.h"
#include "rectilin/search/nearest.h"

namespace rectilin::search {

struct DiffusionOptions {
  std::size_t pool = 400;      ///< members nearest to the query that are ranked anew
  std::size_t neighbours = 3;  ///< of each shape in the pool that it is linked to
  double spread = 0.95;        ///< share of the activation that goes on at each step: 0 to below 1
  int steps = 100;
  std::size_t expand = 2;  ///< so many shapes, itself among them, speak for each shape
  double straight = 4;     ///< how much the distance itself counts, see collection_ranking()
  double reciprocal = 6;   ///< and how much that neighbours are shared
};

/// Manifold ranking (Zhou et al. 2004) on a graph of neighbours with scales of their own (Zelnik-Manor and Perona
/// 2005). `distances` is a symmetric matrix of `size` rows, the query the first of them. Links have the weight exp(-d^2
/// / (s_i s_j)), s the distance to the last of a shape's neighbours; f = spread S f + (1 - spread) e is iterated with
/// the symmetrically normalised weights S. The activation e starts at the query and the shapes nearest to it, `expand`
/// in all, and each shape has the mean of what it and its nearest get. Values are divided by the root of each shape's
/// weight and multiplied by the query's: how much of the query's activation each gets, without the advantage of those
/// that are linked to many.
std::vector<double> diffuse(std::span<const float> distances, std::size_t size, const DiffusionOptions& options = {});

/// How far each shape is from the first by the shape of the collection, on a scale of its own: -log(f / largest f) +
/// straight * d / s + reciprocal * j. d is the distance from the first and s that of the last of its neighbours, j the
/// Jaccard distance of reciprocal neighbours (Zhong et al. 2017). The first shape's own is 0.
std::vector<double> collection_ranking(std::span<const float> distances, std::size_t size,
                                       const DiffusionOptions& options = {});

/// The same with each shape of a collection as the query in turn, among the `pool` others nearest to it; those beyond
/// come after, by their distance. Row i holds the distances from shape i. Runs on all of TBB's threads with the same
/// result for any number of them. What diffused_nearest() finds is this.
retrieval::DistanceMatrix collection_distances(const retrieval::DistanceMatrix& distances,
                                               const DiffusionOptions& options = {});

/// The n members most like the query by diffusion within its pool; members are compared with each other without labels.
/// Distances are those of collection_ranking(). The cost beyond the search does not depend on the collection's size.
/// Deterministic.
std::vector<Neighbour> diffused_nearest(const NearestSearch& search, const Parts& query, std::size_t n,
                                        const std::function<bool(std::size_t)>& keep = {},
                                        const DiffusionOptions& options = {});

/// The same within a pool that was found in another way: nearest first, with their distances from the query.
std::vector<Neighbour> diffused_pool(const NearestSearch& search, std::vector<Neighbour> pool, std::size_t n,
                                     const DiffusionOptions& options = {});

}  // namespace rectilin::search
