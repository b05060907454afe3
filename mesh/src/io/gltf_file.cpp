#include "io/gltf_file.h"

#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "io/bytes.h"
#include "io/scene.h"
#include "io/text.h"

namespace rectilin {
namespace {

constexpr std::size_t kMostBrackets = 64;                      // of brackets in the JSON: parsers recurse
constexpr std::uint64_t kMaxBuffers = std::uint64_t{1} << 31;  // bytes of all buffers together

/// The JSON of a file: all of a text file, the first chunk of a binary one.
std::string_view json_text(std::string_view bytes, const std::string& name) {
  if (!looks_like_glb(bytes)) return bytes;
  constexpr std::size_t kHeader = 20;
  if (bytes.size() < kHeader) throw MeshError(name + ": the file ends within the header");
  const std::size_t length = ByteReader(bytes, 12, std::endian::little, name).read<std::uint32_t>();
  if (length > bytes.size() - kHeader)
    throw MeshError(name + ":byte 12: a chunk of " + std::to_string(length) + " bytes, the file holds " +
                    std::to_string(bytes.size() - kHeader));
  return bytes.substr(kHeader, length);
}

/// Parsers and what they make recurse; a file of brackets must not end the program.
void check_depth(std::string_view json, const std::string& name) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted) {
      if (c == '\\') ++i;
      else if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMostBrackets)
        throw MeshError(name + ":byte " + std::to_string(i) + ": the JSON is nested too deep");
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
}

/// Bytes written as %41; some decoders take '+' for a blank, too.
std::string decoded_uri(std::string_view uri, bool plus_is_blank) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += plus_is_blank && uri[i] == '+' ? ' ' : uri[i];
    }
  }
  return text;
}

/// The files that the buffers are in, and nothing else: images are not even looked for.
struct BufferFiles {
  std::map<std::string, std::string> path_of;  ///< by the path as tinygltf decodes it
  const ReadBeside* beside;

  static bool exists(const std::string& path, void* self) {
    return static_cast<BufferFiles*>(self)->path_of.contains(path);
  }
  static std::string expand(const std::string& path, void*) { return path; }
  static bool read(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* self) {
    const auto& files = *static_cast<BufferFiles*>(self);
    const auto found = files.path_of.find(path);
    if (found == files.path_of.end()) return false;
    if (!*files.beside) {
      *error = "nothing is read beside this file";
      return false;
    }
    const std::string bytes = (*files.beside)(found->second);
    out->assign(bytes.begin(), bytes.end());
    return true;
  }
  static bool write(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
};

/// Looks at the buffers before they are made: their sizes, which are only claimed, and their files.
BufferFiles check_buffers(std::string_view json, bool binary, const ReadBeside& beside, const std::string& name) {
  using Event = nlohmann::json::parse_event_t;
  const auto only_buffers = [](int depth, Event event, nlohmann::json& value) {
    return depth != 1 || event != Event::key || value == "buffers";
  };
  const nlohmann::json root = nlohmann::json::parse(json, only_buffers, false);
  if (root.is_discarded() || !root.is_object()) throw MeshError(name + ": the JSON is malformed");
  BufferFiles files{{}, &beside};
  const auto buffers = root.find("buffers");
  if (buffers == root.end() || !buffers->is_array()) return files;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const nlohmann::json& buffer = (*buffers)[i];
    const std::string what = name + ":buffer " + std::to_string(i) + ": ";
    if (!buffer.is_object()) throw MeshError(what + "not an object");
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned() || *length == 0)
      throw MeshError(what + "its byteLength is not a positive whole number");
    total = SceneCost::sum(total, length->get<std::uint64_t>());
    if (total > kMaxBuffers)
      throw MeshError(what + "the buffers claim more than " + std::to_string(kMaxBuffers) + " bytes");
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      if (!binary || i > 0) throw MeshError(what + "it has no data");
    } else if (!uri->is_string()) {
      throw MeshError(what + "its uri is not a string");
    } else if (const auto& text = uri->get_ref<const std::string&>(); !text.starts_with("data:")) {
      files.path_of[decoded_uri(text, true)] = decoded_uri(text, false);
    }
  }
  return files;
}

}  // namespace

bool looks_like_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

tinygltf::Model parse_gltf(std::string_view bytes, const ReadBeside& beside, const std::string& name) {
  if (bytes.size() > std::numeric_limits<unsigned>::max()) throw MeshError(name + ": larger than 4 GiB");
  const bool binary = looks_like_glb(bytes);
  const std::string_view json = json_text(bytes, name);
  check_depth(json, name);
  BufferFiles files = check_buffers(json, binary, beside, name);
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({&BufferFiles::exists, &BufferFiles::expand, &BufferFiles::read, &BufferFiles::write, &files});
  parser.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error, warning;
  bool done = false;
  const auto size = static_cast<unsigned>(bytes.size());
  try {
    done = binary ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                                reinterpret_cast<const unsigned char*>(bytes.data()), size)
                  : parser.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
  } catch (const MeshError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!done || !error.empty()) {
    const std::string reason = error.substr(0, error.find_first_of("\r\n"));
    throw MeshError(name + ": not valid glTF" + (reason.empty() ? "" : ": " + rectilin::quoted(reason)));
  }
  for (const std::string& extension : model.extensionsRequired) {
    // All others that change the geometry compress it; those for materials and lights do not matter here.
    if (extension.find("compression") != std::string::npos)
      throw MeshError(name + ": it needs the extension " + rectilin::quoted(extension) + ", which is not read");
  }
  return model;
}

}  // namespace rectilin
