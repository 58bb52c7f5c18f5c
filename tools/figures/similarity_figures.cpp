#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/library_clips.h"
#include "figures/palette.h"
#include "figures/png.h"
#include "graph/pose_distance.h"
#include "graph/similarity.h"
#include "graph/valleys.h"

namespace stridegraph::figures {
namespace {

/// Longer clips are shown up to here, so that a cell stays visible.
constexpr std::size_t kMostFrames = 420;
constexpr double kDarkMetres = 0.0;
constexpr double kLightMetres = 0.45;  ///< Opposite phases of a walk are about so far apart.

/// The whole matrix of two clips: only for showing.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::uint32_t> micrometres;
  std::vector<Region> regions;

  double metresAt(std::size_t cell) const { return micrometres[cell] / kMicrometresPerMetre; }
};

Matrix matrixOf(const MotionLibrary& library, const Clip& a, const Clip& b) {
  const Clip both[] = {a, b};
  const FeatureBasis basis = featureBasis(library.skeleton, both);
  const ClipFeatures featuresOfA(library.skeleton, basis, a);
  const ClipFeatures featuresOfB(library.skeleton, basis, b);
  DistanceRows rows(featuresOfA, featuresOfB);
  ValleyFinder valleys({.thresholdMetres = library.params.thresholdMetres,
                        .transitionFrames = library.params.transitionFrames,
                        .neighbourFrames = library.params.neighbourFrames,
                        .largestSpanRatio = library.params.largestSpanRatio});
  valleys.restart(featuresOfB.windowCount());
  Matrix matrix{featuresOfA.windowCount(), featuresOfB.windowCount(), {}, {}};
  for (std::size_t count = rows.advance(); count > 0; count = rows.advance()) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::span<const std::uint32_t> row = rows.row(k);
      matrix.micrometres.insert(matrix.micrometres.end(), row.begin(),
                                row.begin() + static_cast<std::ptrdiff_t>(matrix.columns));
      valleys.addRow(row.first(matrix.columns), rows.firstColumn());
    }
  }
  matrix.regions = valleys.finish();
  return matrix;
}

struct Rgb {
  double red, green, blue;
};

void put(PixelImage& image, const Rgb& colour) {
  for (const double part : {colour.red, colour.green, colour.blue})
    image.bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 255.0))));
}

/// Dark where clips are alike, as in the thesis.
Rgb shade(double metres) {
  constexpr Rgb kDark{22, 34, 62};
  constexpr Rgb kLight{238, 240, 244};
  const double u = std::sqrt(std::clamp((metres - kDarkMetres) / (kLightMetres - kDarkMetres), 0.0, 1.0));
  return {kDark.red + u * (kLight.red - kDark.red), kDark.green + u * (kLight.green - kDark.green),
          kDark.blue + u * (kLight.blue - kDark.blue)};
}

std::string shadedMatrix(const Matrix& matrix) {
  PixelImage image{matrix.columns, matrix.rows, 3, {}};
  for (std::size_t i = 0; i < matrix.micrometres.size(); ++i) put(image, shade(matrix.metresAt(i)));
  return pngDataUri(image);
}

std::string cellsUnder(const Matrix& matrix, double thresholdMetres) {
  PixelImage image{matrix.columns, matrix.rows, 3, {}};
  for (std::size_t i = 0; i < matrix.micrometres.size(); ++i)
    put(image, matrix.metresAt(i) <= thresholdMetres ? Rgb{26, 36, 51} : Rgb{236, 238, 241});
  return pngDataUri(image);
}

void drawRegions(Svg& svg, const Axes& axes, const Matrix& matrix, const LibraryParams& params) {
  const double fps = params.framesPerSecond;
  for (const Region& region : matrix.regions) {
    const double x = static_cast<double>(region.column + kWindowReach) / fps;
    const double y = static_cast<double>(region.row + kWindowReach) / fps;
    const Vec2 ends[] = {axes.at(x, y), axes.at(x + static_cast<double>(region.columnSpan) / fps,
                                                y + static_cast<double>(region.rowSpan) / fps)};
    svg.polyline(ends, {.stroke = palette::kCaptured, .strokePixels = 2.4});
  }
}

/// The shades of panel (a), with their distances.
void drawScale(Svg& svg, const PixelBox& box) {
  constexpr std::size_t kSteps = 120;
  PixelImage image{kSteps, 1, 3, {}};
  for (std::size_t i = 0; i < kSteps; ++i)
    put(image, shade(kLightMetres * static_cast<double>(i) / static_cast<double>(kSteps - 1)));
  svg.image(box, pngDataUri(image), ImageScaling::kSmooth);
  Axes(box, {0.0, 100.0 * kLightMetres, "mean distance of joints (cm)"}, {0.0, 1.0, ""}).drawFrame(svg);
}

}  // namespace

std::vector<Figure> similarityFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  std::vector<LibraryClip> longest = clipsByLength(library);
  if (longest.size() < 2) return {};
  for (LibraryClip& clip : longest)
    clip.frameCount = std::min(clip.frameCount, static_cast<std::uint32_t>(kMostFrames));
  // The longer one goes to the right, so that the panels are as wide as their titles.
  const Clip a = clipOf(library, longest[1]);
  const Clip b = clipOf(library, longest[0]);
  const Matrix matrix = matrixOf(library, a, b);
  if (matrix.rows == 0 || matrix.columns == 0) return {};

  constexpr double kSide = 330.0;
  constexpr double kGap = 26.0;
  constexpr double kTop = 92.0;
  constexpr double kLeft = 64.0;
  const double fps = library.params.framesPerSecond;
  const double cell =
      std::min(kSide / static_cast<double>(matrix.columns), kSide / static_cast<double>(matrix.rows));
  const double width = cell * static_cast<double>(matrix.columns);
  const double height = cell * static_cast<double>(matrix.rows);
  Svg svg(kLeft + 3.0 * width + 2.0 * kGap + 24.0, kTop + height + 106.0, "Similarity matrix of two clips");
  drawHeading(svg, {24.0, 32.0}, fmt::format("Likeness of {} and {}, frame by frame", a.name, b.name),
              fmt::format("{} x {} distances, eq. 5.2, over windows of {} frames", matrix.rows,
                          matrix.columns, kWindowFrames));
  const std::string shaded = shadedMatrix(matrix);
  const std::string titles[] = {
      "(a) distance", fmt::format("(b) under {:g} cm", 100.0 * library.params.thresholdMetres),
      fmt::format("(c) {} regions of {} frames", matrix.regions.size(), library.params.transitionFrames)};
  // Window 0 is centred on frame kWindowReach; each cell covers one frame.
  const double first = (kWindowReach - 0.5) / fps;
  const double acrossSeconds = static_cast<double>(matrix.columns) / fps;
  const double downSeconds = static_cast<double>(matrix.rows) / fps;
  for (std::size_t panel = 0; panel < 3; ++panel) {
    const double left = kLeft + static_cast<double>(panel) * (width + kGap);
    const PixelBox box{left, kTop, left + width, kTop + height};
    svg.image(box, panel == 1 ? cellsUnder(matrix, library.params.thresholdMetres) : shaded,
              ImageScaling::kSquares);
    const Axes axes(box, {first, first + acrossSeconds, fmt::format("time in {} (s)", b.name)},
                    {first + downSeconds, first, panel == 0 ? fmt::format("time in {} (s)", a.name) : ""});
    if (panel == 2) drawRegions(svg, axes, matrix, library.params);
    axes.drawFrame(svg);
    svg.text({left, kTop - 9.0}, titles[panel], {13.0, Anchor::kStart, palette::kInk, true});
  }
  drawScale(svg, {kLeft, kTop + height + 54.0, kLeft + width, kTop + height + 64.0});
  Figure figure{
      "similarity_matrix",
      fmt::format(
          "How far the bodies of two clips are apart at every pair of moments, dark where they are alike "
          "(thesis, fig. 5.3). Dark stripes run along diagonals, one for each step. (b) Of these, only "
          "cells under {:g} cm count; (c) where they stay so for {} frames, the best line of each "
          "valley becomes a transition. Lines lean where one clip steps faster than the other.",
          100.0 * library.params.thresholdMetres, library.params.transitionFrames),
      std::move(svg)};
  std::vector<Figure> figures;
  figures.push_back(std::move(figure));
  return figures;
}

}  // namespace stridegraph::figures
