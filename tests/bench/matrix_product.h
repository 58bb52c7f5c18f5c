#pragma once

#include <cstddef>
#include <memory>
#include <optional>

namespace stridegraph::bench {

/// A large product of matrices of 32 bit floats by Eigen, with AVX2 and fused operations where the build is
/// for x86-64: what one core does at best.
class MatrixProduct {
 public:
  /// None on a machine without the instructions that this was built for.
  static std::optional<MatrixProduct> create();
  MatrixProduct(MatrixProduct&&) noexcept;
  ~MatrixProduct();

  /// Multiplies; the floating-point operations done.
  std::size_t multiply();

 private:
  struct Matrices;
  explicit MatrixProduct(std::unique_ptr<Matrices> matrices);
  std::unique_ptr<Matrices> matrices_;
};

}  // namespace stridegraph::bench
