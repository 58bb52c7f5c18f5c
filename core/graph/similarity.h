#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/frame_features.h"

namespace stridegraph {

/// Distances are handed on in whole micrometres: rounding noise of 32 bit floats then neither breaks ties nor
/// makes sums along diagonals drift.
inline constexpr double kMicrometresPerMetre = 1e6;
/// Larger distances are cut off here: 10 m.
inline constexpr std::uint32_t kFarMicrometres = 10'000'000;

/// The similarity matrix of two clips (fig. 5.3 a), a few rows at a time; never whole in memory, which stays
/// below 150 bytes for each column. Row r, column c is the distance of window r of the one clip and window c
/// of the other (centred on frames r + 2 and c + 2), within 1e-5 m of poseDistanceMetres() (2e-4 m where that
/// is 0: a root magnifies rounding). Borrows both features.
class DistanceRows {
 public:
  static constexpr std::size_t kRowsAtOnce = kProductRows;

  /// No rows until restart().
  DistanceRows() = default;
  DistanceRows(const ClipFeatures& rows, const ClipFeatures& columns);
  /// Of a clip with itself: each row begins at least `reach` columns before the diagonal or at 0; what lies
  /// farther left is the mirror image of what lies right, and is not computed.
  DistanceRows(const ClipFeatures& clip, std::size_t reach);
  /// Goes on with other clips in the same memory, as if made for them.
  void restart(const ClipFeatures& rows, const ClipFeatures& columns);
  void restart(const ClipFeatures& clip, std::size_t reach);

  /// Computes the next rows, kRowsAtOnce or what is left; 0 at the end.
  std::size_t advance();
  /// Row k of those computed last: firstColumn() and on are valid, one entry for each window of the columns.
  std::span<const std::uint32_t> row(std::size_t k) const;
  std::size_t firstColumn() const { return firstColumn_; }

 private:
  static constexpr std::size_t kRing = 2 * kRowsAtOnce;  ///< Frames whose products are kept.

  /// Columns before the first and beyond the last of each row in memory, which windows at the borders reach
  /// into.
  static constexpr std::size_t kLead = kPanelColumns;
  static constexpr std::size_t kTail = 2 * kPanelColumns;

  std::size_t firstColumnFor(std::size_t row) const;
  ProductTargets targetsAt(std::size_t slot);
  void multiplyFrames(std::size_t firstFrame);
  void multiplyMotion();
  void combine();

  const ClipFeatures* rows_ = nullptr;
  const ClipFeatures* columns_ = nullptr;
  std::size_t reach_ = 0;
  std::size_t stride_ = 0;
  std::size_t nextRow_ = 0;
  std::size_t firstColumn_ = 0;
  std::vector<float> along_, across_, height_;     ///< kRing rows of frame products.
  std::vector<float> motionAlong_, motionAcross_;  ///< kRowsAtOnce rows of window products.
  std::vector<float> energies_;                    ///< Of the columns.
  std::vector<std::uint32_t> distances_;           ///< kRowsAtOnce rows.
};

}  // namespace stridegraph
