// What was found, as a web page that opens from disk.
#pragma once

#include <string>
#include <vector>

namespace rectilin::search {

struct PictureOf {
  std::string name, source;  ///< source for load_mesh()
  std::string value;         ///< a line below the name
  std::string png = {};      ///< a picture to be shown as it is instead of the mesh
};

struct PageSection {
  std::string title;
  std::vector<PictureOf> pictures;  ///< the query first
};

/// A section for each query with a picture of each mesh, in the frame of its largest rectilinearity and in one scale;
/// everything is inside the page. A mesh that cannot be read any more has no picture. In parallel; the same bytes for
/// any number of threads.
std::string picture_page(const std::string& title, const std::string& text, const std::vector<PageSection>& sections);

}  // namespace rectilin::search
