// The experiments, each in a file of its own, and what turns an options struct into one.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "rectilin/paper/experiment.h"

namespace rectilin::figures {

Experiment fig1();
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
Experiment table1();
Experiment fig21();
Experiment table2();
Experiment table3();
Experiment table4();
Experiment table5();
Experiment table6();
Experiment fig22();
Experiment gap();
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
