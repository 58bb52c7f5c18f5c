// Compiled for wider registers than all else and with vector code in Eigen: under another name, so that the
// linker mixes nothing of it with the Eigen of core.
#undef EIGEN_DONT_VECTORIZE
#define Eigen WideEigen
#include "matrix_product.h"

#include <Eigen/Core>

#include "stopwatch.h"

namespace stridegraph::bench {
namespace {

constexpr int kSize = 768;
constexpr int kRuns = 20;

bool canRun() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

}  // namespace

std::optional<double> matrixProductGigaflops() {
  if (!canRun()) return {};
  const Eigen::MatrixXf a = Eigen::MatrixXf::Random(kSize, kSize);
  const Eigen::MatrixXf b = Eigen::MatrixXf::Random(kSize, kSize);
  Eigen::MatrixXf product(kSize, kSize);
  const double seconds = leastSeconds(kRuns, [&] { product.noalias() = a * b; });
  return 2.0 * kSize * kSize * kSize / seconds / 1e9;
}

}  // namespace stridegraph::bench
