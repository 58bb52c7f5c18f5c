// Compiled for wider registers than all else and with vector code in Eigen: under another name, so that the
// linker mixes nothing of it with the Eigen of core.
#undef EIGEN_DONT_VECTORIZE
#define Eigen WideEigen
#include "matrix_product.h"

#include <Eigen/Core>

namespace stridegraph::bench {
namespace {

constexpr int kSize = 576;

bool canRun() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

}  // namespace

struct MatrixProduct::Matrices {
  Eigen::MatrixXf a = Eigen::MatrixXf::Random(kSize, kSize);
  Eigen::MatrixXf b = Eigen::MatrixXf::Random(kSize, kSize);
  Eigen::MatrixXf product = Eigen::MatrixXf::Zero(kSize, kSize);
};

MatrixProduct::MatrixProduct(std::unique_ptr<Matrices> matrices) : matrices_(std::move(matrices)) {}
MatrixProduct::MatrixProduct(MatrixProduct&&) noexcept = default;
MatrixProduct::~MatrixProduct() = default;

std::optional<MatrixProduct> MatrixProduct::create() {
  if (!canRun()) return {};
  return MatrixProduct(std::make_unique<Matrices>());
}

std::size_t MatrixProduct::multiply() {
  matrices_->product.noalias() = matrices_->a * matrices_->b;
  return std::size_t{2} * kSize * kSize * kSize;
}

}  // namespace stridegraph::bench
