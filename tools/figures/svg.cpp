#include "figures/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/palette.h"

namespace stridegraph::figures {
namespace {

constexpr std::string_view kFont = "Inter, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
constexpr double kPaperCornerPixels = 8.0;

std::string attributes(const Style& style) {
  std::string text = fmt::format(" fill=\"{}\"", style.fill);
  if (style.stroke != "none")
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{:.3g}\"", style.stroke, style.strokePixels);
  if (!style.dashes.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", style.dashes);
  if (style.opacity < 1.0) text += fmt::format(" opacity=\"{:.3g}\"", style.opacity);
  return text;
}

std::string_view anchorName(Anchor anchor) {
  switch (anchor) {
    case Anchor::kMiddle:
      return "middle";
    case Anchor::kEnd:
      return "end";
    case Anchor::kStart:
      break;
  }
  return "start";
}

std::string pathOf(std::span<const Vec2> points) {
  std::string text;
  for (const Vec2& point : points)
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", pixels(point.x()), pixels(point.y()));
  return text;
}

}  // namespace

std::string escapeXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') {
      escaped += c;
    }
  }
  return escaped;
}

std::string pixels(double value) {
  const long tenths = std::lround(value * 10.0);
  if (tenths % 10 == 0) return fmt::format("{}", tenths / 10);
  return fmt::format("{}{}.{}", tenths < 0 ? "-" : "", std::abs(tenths) / 10, std::abs(tenths) % 10);
}

double textWidth(std::string_view content, const TextStyle& style) {
  // Bytes that go on with a letter begun before take no room of their own.
  const auto letters = std::count_if(content.begin(), content.end(),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return static_cast<double>(letters) * style.sizePixels * (style.bold ? 0.58 : 0.54);
}

Svg::Svg(double widthPixels, double heightPixels, std::string_view title)
    : width_(widthPixels), height_(heightPixels), title_(title) {
  drawn_ = {width_, height_, 0.0, 0.0};
}

void Svg::cover(const PixelBox& box) {
  PixelBox seen = box;
  for (const PixelBox& clip : clips_) {
    seen.left = std::max(seen.left, clip.left);
    seen.top = std::max(seen.top, clip.top);
    seen.right = std::min(seen.right, clip.right);
    seen.bottom = std::min(seen.bottom, clip.bottom);
  }
  if (seen.left > seen.right || seen.top > seen.bottom) return;
  drawn_.left = std::min(drawn_.left, seen.left);
  drawn_.top = std::min(drawn_.top, seen.top);
  drawn_.right = std::max(drawn_.right, seen.right);
  drawn_.bottom = std::max(drawn_.bottom, seen.bottom);
}

void Svg::cover(std::span<const Vec2> points, double margin) {
  for (const Vec2& p : points) cover({p.x() - margin, p.y() - margin, p.x() + margin, p.y() + margin});
}

void Svg::line(const Vec2& from, const Vec2& to, const Style& style) {
  const Vec2 ends[] = {from, to};
  cover(ends, 0.5 * style.strokePixels);
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", pixels(from.x()),
                       pixels(from.y()), pixels(to.x()), pixels(to.y()), attributes(style));
}

void Svg::points(std::string_view element, std::span<const Vec2> points, const Style& style) {
  if (points.size() < 2) return;
  cover(points, style.stroke == "none" ? 0.0 : 0.5 * style.strokePixels);
  body_ += fmt::format("<{} points=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"{}/>\n", element,
                       pathOf(points), attributes(style));
}

void Svg::polyline(std::span<const Vec2> along, const Style& style) {
  points("polyline", along, style);
}

void Svg::polygon(std::span<const Vec2> around, const Style& style) {
  points("polygon", around, style);
}

void Svg::circle(const Vec2& centre, double radius, const Style& style) {
  const Vec2 middle[] = {centre};
  cover(middle, radius);
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", pixels(centre.x()), pixels(centre.y()),
                       pixels(radius), attributes(style));
}

void Svg::ellipse(const Vec2& centre, const Vec2& radii, const Style& style) {
  cover({centre.x() - radii.x(), centre.y() - radii.y(), centre.x() + radii.x(), centre.y() + radii.y()});
  body_ += fmt::format("<ellipse cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"{}/>\n", pixels(centre.x()),
                       pixels(centre.y()), pixels(radii.x()), pixels(radii.y()), attributes(style));
}

void Svg::rectangle(const PixelBox& box, const Style& style, double cornerRadius) {
  cover(box);
  const std::string corner = cornerRadius > 0.0 ? fmt::format(" rx=\"{}\"", pixels(cornerRadius)) : "";
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>\n", pixels(box.left),
                       pixels(box.top), pixels(box.width()), pixels(box.height()), corner, attributes(style));
}

void Svg::text(const Vec2& at, std::string_view content, const TextStyle& style) {
  const double length = textWidth(content, style);
  const double before =
      style.anchor == Anchor::kStart ? 0.0 : (style.anchor == Anchor::kMiddle ? 0.5 * length : length);
  const double rise = 0.78 * style.sizePixels;
  const double fall = 0.22 * style.sizePixels;
  const PixelBox box =
      style.upright ? PixelBox{at.x() - rise, at.y() + before - length, at.x() + fall, at.y() + before}
                    : PixelBox{at.x() - before, at.y() - rise, at.x() - before + length, at.y() + fall};
  cover(box);
  labels_.push_back({box, std::string(content)});
  const std::string turn =
      style.upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", pixels(at.x()), pixels(at.y())) : "";
  body_ +=
      fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n",
                  pixels(at.x()), pixels(at.y()), pixels(style.sizePixels), anchorName(style.anchor),
                  style.fill, style.bold ? " font-weight=\"600\"" : "", turn, escapeXml(content));
}

void Svg::image(const PixelBox& box, std::string_view dataUri, ImageScaling scaling) {
  cover(box);
  body_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "{}href=\"{}\"/>\n",
      pixels(box.left), pixels(box.top), pixels(box.width()), pixels(box.height()),
      scaling == ImageScaling::kSquares ? "style=\"image-rendering:pixelated\" " : "", dataUri);
}

void Svg::path(std::string_view data, const PixelBox& reach, const Style& style) {
  cover(reach);
  body_ += fmt::format("<path d=\"{}\"{}/>\n", data, attributes(style));
}

void Svg::beginClip(const PixelBox& box) {
  clips_.push_back(box);
  definitions_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n",
      clipCount_, pixels(box.left), pixels(box.top), pixels(box.width()), pixels(box.height()));
  body_ += fmt::format("<g clip-path=\"url(#clip{})\">\n", clipCount_++);
}

void Svg::endClip() {
  clips_.pop_back();
  body_ += "</g>\n";
}

std::string Svg::finish() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\" font-family=\"{2}\">\n<title>{3}</title>\n<defs>\n{4}</defs>\n"
      "<rect width=\"{0}\" height=\"{1}\" rx=\"{5}\" fill=\"{6}\"/>\n{7}</svg>\n",
      pixels(width_), pixels(height_), kFont, escapeXml(title_), definitions_, pixels(kPaperCornerPixels),
      palette::kPaper, body_);
}

}  // namespace stridegraph::figures
