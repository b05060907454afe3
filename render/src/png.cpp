#include "rectilin/render/png.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <stdexcept>
#include <vector>

namespace rectilin::render {
namespace {

struct Writer {
  std::string bytes, error;
};

/// libpng's simplified interface takes 16-bit values for linear light and changes them; this one keeps them as they
/// are.
std::string write(const unsigned char* first, std::size_t row_bytes, int width, std::size_t height, int bits,
                  int colours) {
  Writer writer;
  const auto fail = [](png_structp png, png_const_charp message) {
    static_cast<Writer*>(png_get_error_ptr(png))->error = message;
    std::longjmp(png_jmpbuf(png), 1);  // libpng is C: its frames hold nothing to destroy
  };
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, fail, nullptr);
  if (!png) throw std::runtime_error("libpng: no memory");
  png_infop info = png_create_info_struct(png);
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    throw std::runtime_error("libpng: " + writer.error);
  }
  png_set_write_fn(
      png, &writer,
      [](png_structp p, png_bytep data, std::size_t n) {
        static_cast<Writer*>(png_get_io_ptr(p))->bytes.append(reinterpret_cast<const char*>(data), n);
      },
      nullptr);
  png_set_compression_level(png, 6);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits, colours,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (std::size_t y = 0; y < height; ++y) png_write_row(png, first + y * row_bytes);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return std::move(writer.bytes);
}

template <class Value>
std::string png_of(std::span<const Value> values, int width, std::size_t channels = 1) {
  if (width < 1 || values.empty() || values.size() % (static_cast<std::size_t>(width) * channels) != 0)
    throw std::invalid_argument("a picture has whole rows of at least one value");
  const auto row = static_cast<std::size_t>(width) * channels * sizeof(Value);
  return write(reinterpret_cast<const unsigned char*>(values.data()), row, width, values.size_bytes() / row,
               8 * sizeof(Value), channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB);
}

}  // namespace

std::string grey_png(std::span<const std::uint8_t> values, int width) { return png_of(values, width); }
std::string grey_png(std::span<const std::uint16_t> values, int width) { return png_of(values, width); }
std::string colour_png(std::span<const std::uint8_t> values, int width) { return png_of(values, width, 3); }

}  // namespace rectilin::render
