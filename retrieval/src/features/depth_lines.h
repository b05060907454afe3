// Rows and columns of a depth picture as words over a small alphabet, and how far two words are apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rectilin/render/rasterizer.h"

namespace rectilin::retrieval {

/// What a pixel is to the line it lies on: background before the first or behind the last of what is seen, background
/// between, and surface that is level, comes nearer or goes away along the line.
enum class LineState : std::uint8_t { kOutside, kGap, kLevel, kNearer, kFarther };

/// The picture's rows from the top and then its columns from the left, each of image.size states. Surface is level if
/// it rises by at most a quarter of the way along (14 degrees), from its pixel to the next, or where there is none
/// from the one before.
std::vector<LineState> depth_lines(const render::DepthImage& image);

/// The least cost of turning one line into the other, both of one length (Needleman and Wunsch 1970): `gap` for each
/// state left out or put in; 2 for changing background into surface or nearer into farther; 1 for changing the kind of
/// background, or level into one of the slopes. States of which one lies more than `band` places further along its line
/// are not matched. Symmetric, 0 exactly for equal lines, at most twice the length.
int line_distance(std::span<const LineState> a, std::span<const LineState> b, int gap, int band);

}  // namespace rectilin::retrieval
