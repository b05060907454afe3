#include "rectilin/optim/adapters/all_optimizers.h"

#ifdef RECTILIN_WITH_CERES
#include <ceres/version.h>
#endif
#ifdef RECTILIN_WITH_NLOPT
#include <nlopt.hpp>
#endif
#ifdef RECTILIN_WITH_PAGMO
#include <pagmo/config.hpp>
#endif

namespace rectilin {
namespace {

[[maybe_unused]] std::string dotted(int a, int b, int c) {
  return std::to_string(a) + '.' + std::to_string(b) + '.' + std::to_string(c);
}

}  // namespace

const Registry& all_optimizers() {
  static const Registry registry = [] {
    Registry all = builtin_optimizers();
#ifdef RECTILIN_WITH_CERES
    add_ceres(all);
#endif
#ifdef RECTILIN_WITH_NLOPT
    add_nlopt(all);
#endif
#ifdef RECTILIN_WITH_PAGMO
    add_pagmo(all);
#endif
    return all;
  }();
  return registry;
}

Json optimizer_libraries() {
  Json versions = Json::object();
#ifdef RECTILIN_WITH_CERES
  versions["Ceres"] = dotted(CERES_VERSION_MAJOR, CERES_VERSION_MINOR, CERES_VERSION_REVISION);
#endif
#ifdef RECTILIN_WITH_NLOPT
  versions["NLopt"] = dotted(nlopt::version_major(), nlopt::version_minor(), nlopt::version_bugfix());
#endif
#ifdef RECTILIN_WITH_PAGMO
  versions["pagmo"] = dotted(PAGMO_VERSION_MAJOR, PAGMO_VERSION_MINOR, PAGMO_VERSION_PATCH);
#endif
  return versions;
}

}  // namespace rectilin
