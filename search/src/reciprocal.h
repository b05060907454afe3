// How many neighbours two shapes share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rectilin::search {

/// Of each of `size` shapes the indices of the `count` that are nearest, itself first; equal ones by their indices.
/// `distances` is a symmetric matrix, row by row.
using Rankings = std::vector<std::vector<std::uint32_t>>;
Rankings rankings(std::span<const float> distances, std::size_t size, std::size_t count);

struct ReciprocalOptions {
  std::size_t neighbours = 12;  ///< of each shape: those count that have it among theirs
  std::size_t expand = 3;       ///< so many shapes, itself among them, are averaged for each
};

/// The Jaccard distance between the first shape's reciprocal neighbours and those of each shape: 0 if they are the
/// same, 1 if there are none in common. With weights that fall with the distance, neighbours of reciprocal neighbours,
/// and the average over each shape's nearest (Zhong et al. 2017, sections 3.2 to 3.4). Its scale follows the
/// collection's density, as that of diffusion does, but it looks one step far only.
std::vector<double> reciprocal_distances(std::span<const float> distances, std::size_t size,
                                         const ReciprocalOptions& options = {});

}  // namespace rectilin::search
