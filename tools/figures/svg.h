#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/types.h"

namespace stridegraph::figures {

/// A rectangle of a picture, pixels; y grows downwards.
struct PixelBox {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// How a shape is painted. Colours are "#rrggbb", "url(#id)" or "none".
struct Style {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double strokePixels = 1.0;
  double opacity = 1.0;
  std::string_view dashes = {};  ///< As stroke-dasharray, for instance "4 3".
};

enum class ImageScaling { kSquares, kSmooth };

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double sizePixels = 12.0;
  Anchor anchor = Anchor::kStart;
  std::string_view fill = "#1a2433";
  bool bold = false;
  bool upright = false;  ///< Reads from bottom to top.
};

/// The text with what XML gives a meaning replaced, for contents and for attributes in double quotes.
/// Control characters, which XML 1.0 cannot hold, are left out.
std::string escapeXml(std::string_view text);

/// A pixel coordinate as short as a tenth of a pixel allows.
std::string pixels(double value);

/// A picture in the making: shapes are painted in the order in which they are added. Points are pixels, x to
/// the right, y downwards. It notes where it drew, so that tests can see what sticks out or overlaps.
class Svg {
 public:
  /// Paper with rounded corners; `title` is what screen readers say.
  Svg(double widthPixels, double heightPixels, std::string_view title);

  double width() const { return width_; }
  double height() const { return height_; }

  void line(const Vec2& from, const Vec2& to, const Style& style);
  /// Nothing for fewer than two points.
  void polyline(std::span<const Vec2> points, const Style& style);
  void polygon(std::span<const Vec2> points, const Style& style);
  void circle(const Vec2& centre, double radius, const Style& style);
  void ellipse(const Vec2& centre, const Vec2& radii, const Style& style);
  void rectangle(const PixelBox& box, const Style& style, double cornerRadius = 0.0);
  /// `at` is on the base line.
  void text(const Vec2& at, std::string_view content, const TextStyle& style = {});
  /// An image from a data URI.
  void image(const PixelBox& box, std::string_view dataUri, ImageScaling scaling);
  /// Path data of its own; `reach` is what it covers.
  void path(std::string_view data, const PixelBox& reach, const Style& style);
  /// What is drawn until endClip() is cut off outside of the box.
  void beginClip(const PixelBox& box);
  void endClip();

  /// What all shapes and texts cover; texts by an estimate of their width.
  const PixelBox& drawn() const { return drawn_; }
  /// Where each text stands, and what it says.
  struct Label {
    PixelBox box;
    std::string text;
  };
  const std::vector<Label>& labels() const { return labels_; }

  std::string finish() const;

 private:
  void cover(const PixelBox& box);
  void cover(std::span<const Vec2> points, double margin);
  void points(std::string_view element, std::span<const Vec2> points, const Style& style);

  double width_;
  double height_;
  std::string title_;
  std::string definitions_;
  std::string body_;
  PixelBox drawn_;
  std::vector<PixelBox> clips_;
  std::size_t clipCount_ = 0;
  std::vector<Label> labels_;
};

/// The width that a text takes, estimated for a sans serif face.
double textWidth(std::string_view content, const TextStyle& style);

}  // namespace stridegraph::figures
