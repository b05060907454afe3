// The algorithms of NLopt that are offered, with their properties.
#pragma once

#include <nlopt.hpp>

namespace rectilin {

struct NloptAlgorithm {
  nlopt::algorithm id;
  const char* name;
  const char* help;
  bool uses_start = true;   ///< otherwise neither the start nor the seed makes a difference
  bool population = false;  ///< has a population size or number of samples that can be set
  bool sublocal = false;    ///< runs another algorithm inside

  bool local() const { return name[0] == 'L'; }
  bool gradient() const { return name[1] == 'D'; }
};

/// GN_DIRECT_L_NOSCAL and GN_DIRECT_L_RAND_NOSCAL are left out: in NLopt 2.7.1 they evaluate the same points in the
/// same order as GN_DIRECT_NOSCAL.
inline constexpr NloptAlgorithm kNloptAlgorithms[] = {
    {nlopt::LN_COBYLA, "LN_COBYLA", "linear models on a simplex (Powell 1994); local"},
    {nlopt::LN_BOBYQA, "LN_BOBYQA", "quadratic models in a box (Powell 2009); local"},
    {nlopt::LN_NEWUOA_BOUND, "LN_NEWUOA_BOUND", "quadratic models (Powell 2004), with bounds; local"},
    {nlopt::LN_PRAXIS, "LN_PRAXIS", "principal axes (Brent 1973); local"},
    {nlopt::LN_NELDERMEAD, "LN_NELDERMEAD", "simplex (Nelder and Mead 1965), in the domain; local"},
    {nlopt::LN_SBPLX, "LN_SBPLX", "simplices on subspaces (Rowan 1990); local"},
    {nlopt::LD_LBFGS, "LD_LBFGS", "limited-memory BFGS (Nocedal 1980), smooth surrogate; local"},
    {nlopt::LD_MMA, "LD_MMA", "moving asymptotes (Svanberg 2002), smooth surrogate; local"},
    {nlopt::LD_CCSAQ, "LD_CCSAQ", "convex separable quadratic models (Svanberg 2002), smooth surrogate; local"},
    {nlopt::LD_SLSQP, "LD_SLSQP", "sequential quadratic programming (Kraft 1988), smooth surrogate; local"},
    {nlopt::LD_VAR1, "LD_VAR1", "variable metric of rank 1 (Vlcek and Luksan 2006), smooth surrogate; local"},
    {nlopt::LD_VAR2, "LD_VAR2", "variable metric of rank 2 (Vlcek and Luksan 2006), smooth surrogate; local"},
    {nlopt::LD_TNEWTON, "LD_TNEWTON", "truncated Newton (Dembo and Steihaug 1983), smooth surrogate; local"},
    {nlopt::LD_TNEWTON_RESTART, "LD_TNEWTON_RESTART", "truncated Newton with restarts, smooth surrogate; local"},
    {nlopt::LD_TNEWTON_PRECOND, "LD_TNEWTON_PRECOND", "preconditioned truncated Newton, smooth surrogate; local"},
    {nlopt::LD_TNEWTON_PRECOND_RESTART, "LD_TNEWTON_PRECOND_RESTART",
     "preconditioned truncated Newton with restarts, smooth surrogate; local"},
    {nlopt::GN_DIRECT, "GN_DIRECT", "dividing rectangles (Jones et al. 1993)", false},
    {nlopt::GN_DIRECT_L, "GN_DIRECT_L", "dividing rectangles, biased to local search (Gablonsky and Kelley 2001)",
     false},
    {nlopt::GN_DIRECT_L_RAND, "GN_DIRECT_L_RAND", "the same, with random choices among equal rectangles"},
    {nlopt::GN_DIRECT_NOSCAL, "GN_DIRECT_NOSCAL", "dividing rectangles, box not scaled to a cube", false},
    // GN_ORIG_DIRECT and GN_ORIG_DIRECT_L are left out: NLopt 2.7.1 reads out of bounds in them on small budgets.
    {nlopt::GN_CRS2_LM, "GN_CRS2_LM", "controlled random search with local mutation (Kaelo and Ali 2006)", true, true},
    {nlopt::GN_ISRES, "GN_ISRES", "evolution strategy (Runarsson and Yao 2005)", true, true},
    {nlopt::GN_ESCH, "GN_ESCH", "evolutionary algorithm (da Silva Santos et al. 2010)", true, true},
    {nlopt::GN_AGS, "GN_AGS", "space-filling curves (Strongin and Sergeyev 2000)", false},
    {nlopt::GD_STOGO, "GD_STOGO", "branching with local searches (Madsen and Zertchaninov 1998), smooth surrogate",
     false},
    {nlopt::GD_STOGO_RAND, "GD_STOGO_RAND", "the same with random starts"},
    {nlopt::G_MLSL, "G_MLSL", "multi-level single linkage (Rinnooy Kan and Timmer 1987)", true, true, true},
    {nlopt::G_MLSL_LDS, "G_MLSL_LDS", "the same on a low-discrepancy sequence (Kucherenko and Sytsko 2005)", true, true,
     true},
};

}  // namespace rectilin
