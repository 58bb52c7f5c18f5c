#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/axes.h"
#include "figures/body_painter.h"
#include "figures/figure.h"
#include "figures/library_clips.h"
#include "figures/palette.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

constexpr double kWidth = 1180.0;
constexpr double kHeadingPixels = 62.0;
constexpr double kStripPixels = 190.0;
constexpr double kMarginPixels = 46.0;
constexpr double kPixelsPerMetre = 82.0;
constexpr double kSoleMetres = 0.033;  ///< Soles lie so far below the lowest joints.
constexpr std::size_t kPoses = 13;

/// A clip of the default library and what it shows.
struct Subject {
  std::string_view clip;
  std::string_view title;
};
constexpr Subject kSubjects[] = {
    {"walk_1.3", "Walking at 1.3 m/s"}, {"walk_tight_90_left", "Walking round a corner"},
    {"start_left", "Starting to walk"}, {"stop_left", "Coming to a stand"},
    {"jog_2.8", "Jogging at 2.8 m/s"},  {"turn_on_the_spot_180_left", "Turning on the spot"}};

/// Where the strip's poses come from.
struct Strip {
  Clip clip;
  std::string title;
};

/// The subjects; of a library without these clips, its longest ones.
std::vector<Strip> stripsOf(const MotionLibrary& library) {
  std::vector<Strip> strips;
  for (const Subject& subject : kSubjects) {
    if (auto clip = clipNamed(library, subject.clip)) strips.push_back({*clip, std::string(subject.title)});
  }
  if (!strips.empty()) return strips;
  for (const LibraryClip& clip : clipsByLength(library)) {
    if (strips.size() < std::size(kSubjects)) strips.push_back({clipOf(library, clip), clip.name});
  }
  return strips;
}

/// Frames evenly in time over the middle of the clip: as many steps as fit the paper.
std::vector<std::size_t> framesOf(const Clip& clip) {
  const std::size_t every = std::max<std::size_t>(3, clip.frameCount() / kPoses);
  const std::size_t count = std::min(kPoses, (clip.frameCount() - 1) / every + 1);
  const std::size_t first = (clip.frameCount() - 1 - (count - 1) * every) / 2;
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < count; ++i) frames.push_back(first + i * every);
  return frames;
}

/// Bodies stand side by side at even distances, each moved along the strip only; the first heading is to the
/// right.
void drawStrip(Svg& svg, const MotionLibrary& library, const Strip& strip, double topPixels) {
  const std::vector<std::size_t> frames = framesOf(strip.clip);
  const RoundBody body = roundBody(library.skeleton, library.frames);
  const Heading first = rootPlacement(strip.clip.pose(frames.front())).heading - library.facingOffset;
  View view = View::from(first.angle() - Angle::degrees(90.0), Angle::degrees(4.0), kPixelsPerMetre);
  const double floorPixels = topPixels + kStripPixels - 26.0;
  svg.line({kMarginPixels, floorPixels}, {kWidth - kMarginPixels, floorPixels}, {.stroke = palette::kFrame});
  const double spacing = (kWidth - 2.0 * kMarginPixels - 60.0) / static_cast<double>(kPoses - 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Vec3& root = strip.clip.rootPositions[frames[i]];
    const Vec3 below(root.x(), library.floorHeightMetres - kSoleMetres, root.z());
    const double x = kMarginPixels + 30.0 + spacing * static_cast<double>(i);
    view.originPixels = Vec2::Zero();
    view.originPixels = Vec2(x, floorPixels) - view.at(below);
    drawBody(svg, placeParts(body, library.skeleton, strip.clip.pose(frames[i])), view, "#e88a5a");
    svg.text({x, floorPixels + 17.0},
             fmt::format("{:.2f} s", static_cast<double>(frames[i]) / strip.clip.framesPerSecond),
             {11.0, Anchor::kMiddle, palette::kQuiet});
  }
}

}  // namespace

std::vector<Figure> poseFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const std::vector<Strip> strips = stripsOf(library);
  Svg svg(kWidth, 20.0 + (kHeadingPixels + kStripPixels) * static_cast<double>(strips.size()),
          "Clips of the library from the side");
  double top = 10.0;
  for (const Strip& strip : strips) {
    const ClipManner manner = mannerOf(strip.clip);
    drawHeading(
        svg, {kMarginPixels, top + 26.0}, strip.title,
        fmt::format("{}{} frames, mean {:.2f} m/s, turns by {:.0f}\u00b0 in all",
                    strip.title == strip.clip.name ? "" : strip.clip.name + ": ", strip.clip.frameCount(),
                    manner.speedMetresPerSecond, std::abs(manner.turn.degrees())));
    drawStrip(svg, library, strip, top + kHeadingPixels);
    top += kHeadingPixels + kStripPixels;
  }
  std::vector<Figure> figures;
  figures.push_back({"poses",
                     "Clips of the library, seen from the side at even moments and set side by side. Arms "
                     "swing against the legs, the standing foot stays flat until its heel rises, and the "
                     "body sinks a little where both feet are down.",
                     std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
