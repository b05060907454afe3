# Writes FILE's bytes as a C++ source: cmake -DFILE=... -DOUT=... -P embed.cmake
file(READ ${FILE} hex HEX)
file(SIZE ${FILE} size)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
file(WRITE ${OUT} "#include <cstddef>
namespace rectilin::retrieval {
extern const unsigned char kWordsFile[];
extern const std::size_t kWordsFileSize;
const unsigned char kWordsFile[] = {${bytes}0};
const std::size_t kWordsFileSize = ${size};
}
")
