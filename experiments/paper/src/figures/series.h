// What most figures of the paper are: meshes that differ in one number, and R of each.
#pragma once

#include <string>
#include <vector>

#include "figures/sample.h"

namespace rectilin::paper::figures {

struct Series {
  std::string name;          ///< of the files
  std::string title;         ///< of the picture
  std::string caption;       ///< what to see in it
  report::Axis axis;         ///< of the number
  bool logarithmic = false;  ///< the scale of R

  struct Member {
    double number;
    Sample sample;
  };
  std::vector<Member> members = {};   ///< by increasing number
  std::vector<Sample> compared = {};  ///< meshes without the number: a level line each
};

struct MeasuredSeries {
  std::vector<Measured> members, compared;
  ExperimentResult result;  ///< complete but for what it says
};

/// "falls from 1.0000 to 0.4000", "rises from ... to ..." or, if it does neither throughout, "goes
/// from ... to ...".
std::string course_text(const std::vector<Measured>& members);

/// Measures all and draws R against the number.
MeasuredSeries measure(const Series& series, const ExperimentContext& context);

}  // namespace rectilin::paper::figures
