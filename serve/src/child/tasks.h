// What a child process is asked to do with a mesh, and does.
//
// Task and answer are CBOR (RFC 8949). File names are byte strings, since they may be in any encoding.
//
//     {task: "picture" or "mesh", source, digest}     {bytes}
//     {task: "describe", folder, source, descriptor}  {faces, rectilinearity, size, left_out, parts, picture, mesh}
//     {task: "turn", first, second}                   {rotation, distance}
//                                                     {error}, if it cannot be done
#pragma once

#include <string_view>

#include "rectilin/base/parameters.h"

namespace rectilin::serve {

inline Json as_bytes(std::string_view text) { return Json::binary({text.begin(), text.end()}); }

/// Throws what readers throw.
Json do_task(const Json& task);

}  // namespace rectilin::serve
