// From names to descriptors.
#include "descriptors/best.h"
#include "descriptors/dla.h"
#include "descriptors/extents.h"
#include "descriptors/gsmd.h"
#include "descriptors/histograms.h"
#include "descriptors/lfd.h"
#include "descriptors/rectilinearity.h"
#include "descriptors/shd.h"
#include "descriptors/swc.h"
#include "descriptors/views.h"
#include "descriptors/words.h"
#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

const DescriptorFactory& descriptors() {
  static const DescriptorFactory factory = [] {
    DescriptorFactory f("descriptor");
    add_rectilinearity(f);
    add_histograms(f);
    add_shd(f);
    add_gsmd(f);
    add_lfd(f);
    add_views(f);
    add_words(f);
    add_extents(f);
    add_best(f);
    add_swc(f);
    add_dla(f);
    return f;
  }();
  return factory;
}

}  // namespace rectilin::retrieval
