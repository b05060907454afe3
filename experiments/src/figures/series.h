// What most figures of the paper are: meshes that differ in one number, and R of each.
#pragma once

#include <string>
#include <vector>

#include "specimen.h"

namespace rectilin::figures {

struct Series {
  std::string name;     ///< of the files
  std::string title;    ///< of the picture
  std::string caption;  ///< what to see in it
  Axis axis;            ///< of the number

  struct Member {
    double number;
    Specimen specimen;
  };
  std::vector<Member> members = {};     ///< by increasing number
  std::vector<Specimen> compared = {};  ///< meshes without the number: a level line each
};

struct MeasuredSeries {
  std::vector<Measured> members, compared;
  ExperimentResult result;  ///< complete but for what it says
};

/// Measures all and draws R against the number.
MeasuredSeries measure(const Series& series, const ExperimentContext& context);

}  // namespace rectilin::figures
