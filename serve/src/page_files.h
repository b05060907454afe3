// The files of the page, read into memory once: no request ever opens one of them.
#pragma once

#include <map>
#include <string>

#include "http/message.h"

namespace rectilin::serve {

struct PageFile {
  std::string type;
  Bytes bytes;
  std::string tag;  ///< for If-None-Match
};

struct PageFiles {
  std::map<std::string, PageFile> files;  ///< by path: "/", "/style.css", "/viewer/three.module.js" ...
  bool viewer = false;                    ///< three.js is there, for pictures in 3D
};

/// Where they are, relative to this program: in the folder it was built in, or installed. Throws std::runtime_error if
/// they are in neither.
PageFiles load_page_files();

}  // namespace rectilin::serve
