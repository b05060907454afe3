// A page to search a database of shapes with, served to browsers.
//
// Meshes are read by child processes with limits of time and memory, never by the server itself; files are served only
// if they are members of the database and still have the bytes that were indexed. papers/search.md has the API.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"

namespace rectilin::serve {

struct ServeOptions {
  std::string database;
  std::string address = "127.0.0.1";  ///< of numbers, IPv4 or IPv6; 0.0.0.0 lets other machines in
  std::uint16_t port = 8737;          ///< 0: any that is free
  std::vector<std::string> hosts;     ///< names that browsers may know the server by, besides addresses and localhost
  std::uint64_t upload_bytes = 256u << 20;  ///< size of an uploaded file
  bool approximate = false;                 ///< search by a graph of neighbours, see search/approximate.h
  OnProgress on_progress = {};              ///< of building that graph
  std::vector<std::string> worker_command;  ///< runs run_mesh_worker(): a path and arguments
};

struct Started {
  std::string url;
  std::size_t shapes = 0;
  bool viewer = false;  ///< shapes can be shown in 3D
  std::string note;     ///< what was amiss with the graph, if anything
};

/// Serves until it is asked to stop. Calls `started` once browsers can come. Throws std::runtime_error, one line, if
/// the database cannot be read or the address not be used; Stopped if that was asked while the graph was built.
void serve(const ServeOptions& options, const std::function<void(const Started&)>& started, std::stop_token stop);

/// What a child process does: one task, from standard input to standard output. Returns the exit status.
int run_mesh_worker();

}  // namespace rectilin::serve
