// Pictures as PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace rectilin::render {

/// The bytes of a PNG file with grey values of 8 or 16 bits, `width` a row, rows from the top, 0 black. Equal pictures
/// give equal bytes. Throws std::invalid_argument if the values do not fill whole rows, std::runtime_error if libpng
/// fails.
std::string grey_png(std::span<const std::uint8_t> values, int width);
std::string grey_png(std::span<const std::uint16_t> values, int width);

/// The same with three values a pixel: red, green and blue, in sRGB.
std::string colour_png(std::span<const std::uint8_t> values, int width);

}  // namespace rectilin::render
