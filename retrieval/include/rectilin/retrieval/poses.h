// The poses that descriptors may ask for.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rectilin {
class Parameters;
}

namespace rectilin::retrieval {

/// Names for Model::frame(), each with what it stands for.
const std::vector<std::pair<std::string, std::string>>& pose_names();

/// The parameter `pose` of a descriptor, one of the names.
void bind_pose(Parameters& parameters, std::string& pose);

}  // namespace rectilin::retrieval
