#include "target.h"

// libFuzzer calls this with its inputs. STRIDEGRAPH_FUZZ_TARGET is the function of target.h that this program
// is for; what it throws ends the program, and libFuzzer keeps the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stridegraph::fuzz::STRIDEGRAPH_FUZZ_TARGET({data, size});
  return 0;
}
