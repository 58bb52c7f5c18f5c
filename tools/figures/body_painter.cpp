#include "figures/body_painter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "figures/png.h"
#include "figures/soft_body.h"

namespace stridegraph::figures {
namespace {

constexpr double kImagePixelsPerPixel = 1.5;  ///< So that pictures stay sharp on fine screens.
constexpr std::size_t kTile = 12;             ///< Image pixels that share a part of the body.
constexpr int kRaysAcross = 2;                ///< In each direction, for every image pixel.
constexpr double kMarginMetres = 0.02;
constexpr double kHitMetres = 1e-3;
constexpr double kGrazedMetres = 5e-3;  ///< So near after all steps, a ray grazes the body.
constexpr int kMostSteps = 60;

using Rgb = std::array<double, 3>;

Rgb parse(std::string_view colour) {
  Rgb rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    int value = 0;
    std::from_chars(colour.data() + 1 + 2 * i, colour.data() + 3 + 2 * i, value, 16);
    rgb[i] = value;
  }
  return rgb;
}

/// What a body covers in the plane of the picture, metres to the right and up, and how near it comes.
struct Extent {
  Vec2 low = Vec2::Constant(1e9);
  Vec2 high = Vec2::Constant(-1e9);
  double nearest = -1e9;

  void add(const View& view, const Vec3& point, double radius) {
    const Vec2 flat(view.right.dot(point), view.up.dot(point));
    const Vec2 reach = Vec2::Constant(radius + kMarginMetres);
    low = low.cwiseMin(flat - reach);
    high = high.cwiseMax(flat + reach);
    nearest = std::max(nearest, view.toward.dot(point) + radius + kMarginMetres);
  }
};

Extent extentOf(const View& view, const std::vector<Capsule>& capsules) {
  Extent extent;
  for (const Capsule& capsule : capsules) {
    extent.add(view, capsule.from, capsule.fromRadius);
    extent.add(view, capsule.to, capsule.toRadius);
  }
  return extent;
}

class Renderer {
 public:
  Renderer(const std::vector<Capsule>& capsules, const View& view, std::string_view colour)
      : body_(capsules), view_(view), colour_(parse(colour)), extent_(extentOf(view, capsules)) {}

  /// Red, green, blue and opacity.
  PixelImage render() {
    const double scale = kImagePixelsPerPixel * view_.pixelsPerMetre;
    const Vec2 size = scale * (extent_.high - extent_.low);
    image_.width = static_cast<std::size_t>(std::ceil(size.x()));
    image_.height = static_cast<std::size_t>(std::ceil(size.y()));
    image_.channels = 4;
    image_.bytes.assign(image_.width * image_.height * 4, 0);
    for (std::size_t row = 0; row < image_.height; row += kTile) {
      for (std::size_t column = 0; column < image_.width; column += kTile) renderTile(column, row);
    }
    return std::move(image_);
  }

  /// Where the image goes in the picture.
  PixelBox place() const {
    const double pixel = 1.0 / kImagePixelsPerPixel;
    const Vec2 topLeft = view_.originPixels + view_.pixelsPerMetre * Vec2(extent_.low.x(), -extent_.high.y());
    return {topLeft.x(), topLeft.y(),
            topLeft.x() + pixel * std::ceil(sizeOf(extent_.high.x() - extent_.low.x())),
            topLeft.y() + pixel * std::ceil(sizeOf(extent_.high.y() - extent_.low.y()))};
  }

 private:
  double sizeOf(double metres) const { return kImagePixelsPerPixel * view_.pixelsPerMetre * metres; }

  /// A place in the image as metres to the right and up in the plane of the picture.
  Vec2 flatAt(double column, double row) const {
    const double metres = 1.0 / (kImagePixelsPerPixel * view_.pixelsPerMetre);
    return {extent_.low.x() + metres * column, extent_.high.y() - metres * row};
  }

  void renderTile(std::size_t column, std::size_t row) {
    const Vec2 topLeft = flatAt(static_cast<double>(column), static_cast<double>(row));
    const Vec2 bottomRight = flatAt(static_cast<double>(column + kTile), static_cast<double>(row + kTile));
    const SoftBody near = body_.part([&](const Capsule& capsule) {
      Extent reach;
      reach.add(view_, capsule.from, capsule.fromRadius);
      reach.add(view_, capsule.to, capsule.toRadius);
      // What lies beside the tile still bends the surface within it and shades it.
      constexpr double kShadeMetres = 0.06;
      return reach.low.x() < bottomRight.x() + kShadeMetres && reach.high.x() > topLeft.x() - kShadeMetres &&
             reach.low.y() < topLeft.y() + kShadeMetres && reach.high.y() > bottomRight.y() - kShadeMetres;
    });
    if (near.empty()) return;
    for (std::size_t r = row; r < std::min(row + kTile, image_.height); ++r) {
      for (std::size_t c = column; c < std::min(column + kTile, image_.width); ++c) renderPixel(near, c, r);
    }
  }

  void renderPixel(const SoftBody& body, std::size_t column, std::size_t row) {
    Rgb sum{};
    int hits = 0;
    for (int ray = 0; ray < kRaysAcross * kRaysAcross; ++ray) {
      const double right = (ray % kRaysAcross + 0.5) / kRaysAcross;
      const double down = (ray / kRaysAcross + 0.5) / kRaysAcross;
      const auto point =
          hit(body, flatAt(static_cast<double>(column) + right, static_cast<double>(row) + down));
      if (!point) continue;
      ++hits;
      const Rgb seen = shade(body, *point);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += seen[i];
    }
    if (hits == 0) return;
    std::uint8_t* pixel = &image_.bytes[4 * (row * image_.width + column)];
    for (std::size_t i = 0; i < 3; ++i)
      pixel[i] = static_cast<std::uint8_t>(std::lround(std::clamp(sum[i] / hits, 0.0, 255.0)));
    pixel[3] = static_cast<std::uint8_t>(std::lround(255.0 * hits / (kRaysAcross * kRaysAcross)));
  }

  /// Where a ray from the viewer first meets the body (sphere tracing, Hart 1996).
  std::optional<Vec3> hit(const SoftBody& body, const Vec2& flat) const {
    constexpr double kDeepMetres = 2.2;
    double depth = extent_.nearest;
    for (int step = 0; depth > extent_.nearest - kDeepMetres; ++step) {
      const Vec3 point = flat.x() * view_.right + flat.y() * view_.up + depth * view_.toward;
      const double distance = body.distance(point);
      if (distance < (step < kMostSteps ? kHitMetres : kGrazedMetres)) return point;
      if (step > kMostSteps) break;
      depth -= distance;
    }
    return std::nullopt;
  }

  Rgb shade(const SoftBody& body, const Vec3& point) const {
    const Vec3 normal = body.normal(point);
    const Vec3 light = (-0.45 * view_.right + 0.75 * view_.up + 0.50 * view_.toward).normalized();
    const double sun = std::max(0.0, 0.5 + 0.5 * normal.dot(light));
    const double sky = 0.5 + 0.5 * normal.y();
    double open = 1.0;
    for (const double reach : {0.02, 0.05})
      open -= 4.0 * std::max(0.0, reach - body.distance(point + reach * normal));
    const double shine = std::pow(std::max(0.0, normal.dot((light + view_.toward).normalized())), 24.0);
    const double bright = (0.40 + 0.66 * sun * sun + 0.12 * sky) * std::clamp(open, 0.55, 1.0);
    Rgb seen{};
    for (std::size_t i = 0; i < 3; ++i) seen[i] = colour_[i] * bright + 26.0 * shine;
    return seen;
  }

  SoftBody body_;
  const View& view_;
  Rgb colour_;
  Extent extent_;
  PixelImage image_;
};

}  // namespace

View View::from(Angle from, Angle elevation, double pixelsPerMetre) {
  const Vec2 side = Heading::fromAngle(from).direction();
  const double sine = std::sin(elevation.radians());
  const double cosine = std::cos(elevation.radians());
  View view;
  view.toward = {cosine * side.x(), sine, cosine * side.y()};
  view.right = {side.y(), 0.0, -side.x()};
  view.up = view.toward.cross(view.right);
  view.pixelsPerMetre = pixelsPerMetre;
  return view;
}

Vec2 View::at(const Vec3& point) const {
  return originPixels + pixelsPerMetre * Vec2(right.dot(point), -up.dot(point));
}

void drawBody(Svg& svg, const std::vector<Capsule>& body, const View& view, std::string_view colour) {
  Renderer renderer(body, view, colour);
  svg.image(renderer.place(), pngDataUri(renderer.render()), ImageScaling::kSmooth);
}

}  // namespace stridegraph::figures
