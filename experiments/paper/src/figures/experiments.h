// The experiments, each in a file of its own, and what turns an options struct into one.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "rectilin/paper/experiment.h"

namespace rectilin::figures {

Experiment fig1();
Experiment fig2();
Experiment fig5();
Experiment fig6();
Experiment fig7();
Experiment fig8();
Experiment fig9();
Experiment fig10();
Experiment fig11();
Experiment fig12();
Experiment fig13();
Experiment fig14();
Experiment fig15();
Experiment fig16();
Experiment fig17();
Experiment fig18();
Experiment fig19();
Experiment fig20();
Experiment gap();
Experiment pose_accuracy();
Experiment shortfall();

/// An experiment from a struct of settings with `bind(Parameters&)` and `run(const
/// ExperimentContext&) const`. `quick` are settings as after the '?' of a Spec: with them it takes
/// about a second.
template <class Settings>
Experiment make_experiment(const std::string& name, std::string title, std::string takes, const std::string& quick) {
  Settings defaults;
  Parameters shown;
  defaults.bind(shown);
  const auto run = [name](const Json& settings, const ExperimentContext& context) {
    Settings own;
    Parameters table;
    own.bind(table);
    table.set(settings, name);
    return std::as_const(own).run(context);
  };
  std::string spec = name;
  if (!quick.empty()) spec.append("?").append(quick);
  return {name, std::move(title), std::move(takes), shown.describe(), Spec::parse(spec).settings, run};
}

}  // namespace rectilin::figures
