#include "gait_fit/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gait_fit/lean.h"
#include "motion/kinematics.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr double kPi = std::numbers::pi;
constexpr const char* kCapturedColour = "#9a9a9a";
constexpr const char* kModelColour = "#c0392b";

/// Collects SVG elements; coordinates are pixels.
class Drawing {
 public:
  Drawing(double width, double height) : width_(width), height_(height) {}
  void line(const Vec2& from, const Vec2& to, const char* colour, double thickness = 2.0) {
    body_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
        from.x(), from.y(), to.x(), to.y(), colour, thickness);
  }
  void dot(const Vec2& at, const char* colour, double radius = 2.0) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", at.x(), at.y(),
                         radius, colour);
  }
  void text(const Vec2& at, const std::string& words, const char* colour = "#333") {
    body_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" font-family=\"sans-serif\" font-size=\"13\">{}</text>\n",
        at.x(), at.y(), colour, words);
  }
  void legend(const std::string& title) {
    text({10, 18}, title);
    text({10, 36}, "captured", kCapturedColour);
    text({80, 36}, "synthesised", kModelColour);
  }
  std::string svg() const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 "
               "{0:g} {1:g}\">\n"
               "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
               width_, height_) +
           body_ + "</svg>\n";
  }

 private:
  double width_;
  double height_;
  std::string body_;
};

enum class View { kSide, kFront };

void drawBody(Drawing& drawing, const Pose& pose, View view, const Vec2& foot, const char* colour) {
  constexpr double kPixelsPerMetre = 120.0;
  const Skeleton skeleton = gaitSkeleton();
  const auto points = jointPositions(skeleton, pose.view());
  const auto place = [&](const Vec3& p) {
    return Vec2(foot.x() + kPixelsPerMetre * (view == View::kSide ? p.z() : p.x()),
                foot.y() - kPixelsPerMetre * p.y());
  };
  for (std::size_t j = 1; j < points.size(); ++j)
    drawing.line(place(points[skeleton.joints[j].parent->value]), place(points[j]), colour);
}

/// The frame away from the clip's ends whose phase is nearest to `phase`.
Index nearestFrame(const Track& track, double phase) {
  Index best = kEndFrames;
  double least = 10.0;
  for (Index f = kEndFrames; f + kEndFrames < track.frames(); ++f) {
    const double apart =
        std::abs(std::remainder(track.phase[f] - phase, 2.0 * kPi)) + (track.going[f] > 0.0 ? 0.0 : 5.0);
    if (apart >= least) continue;
    least = apart;
    best = f;
  }
  return best;
}

Picture drawCycle(const Track& track, const GaitTable& table, const std::string& name) {
  constexpr int kPhases = 8;
  constexpr double kCell = 150.0;
  Drawing drawing(kPhases * kCell, 540.0);
  drawing.legend(track.clip.name);
  for (int i = 0; i < kPhases; ++i) {
    const Index f = nearestFrame(track, 2.0 * kPi * i / kPhases);
    const Pose captured = poseOnPath(track, f);
    const Pose model = gaitPose(table, track.state(f));
    for (const View view : {View::kSide, View::kFront}) {
      const Vec2 foot((i + 0.5) * kCell, view == View::kSide ? 275.0 : 510.0);
      drawing.line(foot - Vec2(60, 0), foot + Vec2(60, 0), "#ddd", 1.0);
      drawBody(drawing, captured, view, foot, kCapturedColour);
      drawBody(drawing, model, view, foot, kModelColour);
    }
    drawing.text({(i + 0.5) * kCell - 15, 532}, fmt::format("{}/8", i));
  }
  return {name, drawing.svg()};
}

/// Ankle to toe end, on the floor, of the foot that stands at a frame.
struct Print {
  Vec2 ankle;
  Vec2 toe;
};
Print printAt(const Track& track, Index f, const Pose& pose, Side side) {
  const auto points = jointPositions(gaitSkeleton(), pose.view());
  const std::size_t ankle = gaitLeg(side).ankle.value;
  const FloorTransform worldFromPath{track.path.row(f).transpose(),
                                     Heading::fromAngle(Angle::radians(track.heading[f]))};
  return {worldFromPath * onFloor(points[ankle]), worldFromPath * onFloor(points[ankle + 2])};
}

Picture drawFootprints(const Track& track, const GaitTable& table, const std::string& name) {
  constexpr double kSize = 600.0;
  constexpr double kMargin = 60.0;
  const Vec2 low = track.path.colwise().minCoeff().transpose();
  const Vec2 high = track.path.colwise().maxCoeff().transpose();
  const double scale = (kSize - 2 * kMargin) / std::max(1.0, (high - low).maxCoeff());
  const auto place = [&](const Vec2& p) {
    return Vec2(kSize - kMargin - scale * (p.x() - low.x()), kSize - kMargin - scale * (p.y() - low.y()));
  };
  Drawing drawing(kSize, kSize);
  drawing.legend(track.clip.name + ": feet in mid-stance, from above");
  for (Index f = 0; f + 1 < track.frames(); ++f) {
    drawing.line(place(track.path.row(f).transpose()), place(track.path.row(f + 1).transpose()), "#ddd", 1.0);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double shift = side == Side::kLeft ? -0.5 * kPi : 0.5 * kPi;
      const double before = std::remainder(track.phase[f] + shift, 2.0 * kPi);
      const double after = std::remainder(track.phase[f + 1] + shift, 2.0 * kPi);
      if (before > 0.0 || after <= 0.0 || after - before > kPi || track.going[f] <= 0.0) continue;
      const Print seen = printAt(track, f, poseOnPath(track, f), side);
      const Print made = printAt(track, f, gaitPose(table, track.state(f)), side);
      drawing.line(place(seen.ankle), place(seen.toe), kCapturedColour, 6.0);
      drawing.line(place(made.ankle), place(made.toe), kModelColour, 3.0);
    }
  }
  return {name, drawing.svg()};
}

Picture drawLean(const GaitFit& fit, const GaitTable& table, const std::string& name) {
  constexpr double kWidth = 600.0;
  constexpr double kHeight = 400.0;
  Drawing drawing(kWidth, kHeight);
  drawing.legend("lean of the trunk over the standing foot, degrees, against sideways acceleration, m/s^2");
  const auto place = [&](double sideways, double degrees) {
    return Vec2(0.5 * kWidth + 70.0 * sideways, 0.5 * kHeight - 5.0 * degrees);
  };
  drawing.line(place(-4, 0), place(4, 0), "#ddd", 1.0);
  drawing.line(place(0, -28), place(0, 28), "#ddd", 1.0);
  for (const int tick : {-3, -2, -1, 1, 2, 3}) drawing.text(place(tick, -2.5), fmt::format("{}", tick));
  for (const int tick : {-20, -10, 10, 20}) drawing.text(place(0.05, tick), fmt::format("{}", tick));
  for (const Track& track : fit.tracks)
    for (const LeanSample& sample : leanSamples(track, table)) {
      drawing.dot(place(sample.sideways, sample.captured), kCapturedColour);
      drawing.dot(place(sample.sideways, sample.model), kModelColour);
    }
  return {name, drawing.svg()};
}

}  // namespace

std::vector<Picture> picturesOf(const GaitFit& fit, const GaitTable& table, const std::string& gait) {
  const auto bend = [](const Track& track) { return track.heading.maxCoeff() - track.heading.minCoeff(); };
  const auto [straight, sharp] =
      std::minmax_element(fit.tracks.begin(), fit.tracks.end(),
                          [&](const Track& a, const Track& b) { return bend(a) < bend(b); });
  return {drawCycle(*straight, table, gait + "_straight"), drawCycle(*sharp, table, gait + "_turn"),
          drawFootprints(*sharp, table, gait + "_footprints"), drawLean(fit, table, gait + "_lean")};
}

}  // namespace stridegraph::gait_fit
