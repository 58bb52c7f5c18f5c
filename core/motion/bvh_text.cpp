#include "motion/bvh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/utf16.h"
#include "base/utf8.h"
#include "motion/bvh_content.h"
#include "motion/bvh_limits.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kAsciiBlanks = " \t\v\f";
/// What some programs write behind the end of a text: zeros of a buffer, the end-of-file character of DOS.
constexpr std::string_view kPadding = "\0\x1A"sv;
constexpr std::size_t kMostQuotedLines = 6;
constexpr std::size_t kMostQuotedCharacters = 40;
constexpr std::size_t kMostNamedCharacters = 4;

tl::unexpected<Error> refuse(std::string_view found, std::string_view file) {
  return fail(ErrorCode::kBvhSyntax,
              fmt::format("found {}, expected a BVH text, which begins with HIERARCHY", found),
              {std::string(file)});
}

/// True for printable ASCII, tabs and line ends: what nothing has to be done about. Goes through all bytes in
/// any case, and in bytes alone, so that compilers make vector code of it.
bool isPlain(std::string_view bytes) {
  std::uint8_t odd = 0;
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    const auto isNotPrintable = static_cast<std::uint8_t>(static_cast<std::uint8_t>(byte - 0x20U) >= 0x5FU);
    const auto isNoBlank = static_cast<std::uint8_t>(static_cast<std::uint8_t>(byte - 0x09U) >= 5U);
    odd |= isNotPrintable & isNoBlank;
  }
  return odd == 0;
}

bool isControl(char32_t c) {
  return (c < 0x20 && (c < 0x09 || c > 0x0D)) || (c >= 0x7F && c <= 0x9F);
}

/// Blanks and what has no width: White_Space of the Unicode Character Database beyond ASCII, U+200B and the
/// byte-order mark.
bool isOddBlank(char32_t c) {
  return c == 0xA0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200B) || c == 0x2028 || c == 0x2029 ||
         c == 0x202F || c == 0x205F || c == 0x3000 || c == 0xFEFF;
}

/// The code point at the beginning of well-formed UTF-8, and its bytes.
struct Character {
  char32_t codePoint;
  std::size_t bytes;
};

Character firstOf(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80U) return {lead, 1};
  const std::size_t bytes = lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
  char32_t codePoint = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i)
    codePoint = codePoint << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  return {codePoint, bytes};
}

/// What a line says, for a message: without outer blanks, a keyword in front and a brace behind, shortened.
std::string quoted(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(kAsciiBlanks), line.size()));
  const std::size_t blank = line.find_first_of(kAsciiBlanks);
  if (blank != std::string_view::npos) line.remove_prefix(blank);
  line.remove_prefix(std::min(line.find_first_not_of(kAsciiBlanks), line.size()));
  line = line.substr(0, line.find('{'));
  while (!line.empty() && kAsciiBlanks.find(line.back()) != std::string_view::npos) line.remove_suffix(1);
  std::size_t end = 0;
  for (std::size_t count = 0; end < line.size() && count < kMostQuotedCharacters; ++count)
    end += firstOf(line.substr(end)).bytes;
  return fmt::format("\"{}{}\"", line.substr(0, end), end < line.size() ? "..." : "");
}

/// Makes the text line by line and remembers what was odd.
class LineDecoder {
 public:
  LineDecoder(std::string_view bytes, std::string_view file) : rest_(bytes), file_(file) {
    text_.reserve(bytes.size() + bytes.size() / 16);
  }

  std::string decode() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
      takeLine(rest_.substr(0, end));
      rest_.remove_prefix(end);
      takeLineEnd();
    }
    return std::move(text_);
  }

  bool hasControls() const { return hasControls_; }
  Warnings warnings() const {
    Warnings warnings;
    if (otherLines_ > 0) warnings.push_back(warningOfOtherLines());
    if (replaced_ > 0) warnings.push_back(warningOfReplaced());
    return warnings;
  }

 private:
  void takeLineEnd() {
    if (rest_.empty()) return;
    const std::size_t bytes = rest_.starts_with("\r\n") ? 2 : 1;
    text_ += rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    ++line_;
  }

  void takeLine(std::string_view bytes) {
    if (isPlain(bytes)) {
      text_ += bytes;
      return;
    }
    const std::size_t begin = text_.size();
    if (isUtf8(bytes)) {
      appendCleaned(bytes);
      return;
    }
    appendCleaned(toUtf8(bytes));
    if (otherLines_++ == 0) firstOtherLine_ = line_;
    if (otherLines_ > kMostQuotedLines) return;
    quotes_ += fmt::format("{}{} (line {})", quotes_.empty() ? "" : ", ",
                           quoted(std::string_view(text_).substr(begin)), line_);
  }

  void appendCleaned(std::string_view line) {
    for (std::size_t column = 1; !line.empty(); ++column) {
      const Character character = firstOf(line);
      if (isControl(character.codePoint) || isOddBlank(character.codePoint)) {
        text_ += ' ';
        remember(character.codePoint, column);
      } else {
        text_ += line.substr(0, character.bytes);
      }
      line.remove_prefix(character.bytes);
    }
  }

  void remember(char32_t codePoint, std::size_t column) {
    if (replaced_++ == 0) firstReplaced_ = {file_, line_, column};
    hasControls_ |= isControl(codePoint);
    if (std::find(kinds_.begin(), kinds_.end(), codePoint) == kinds_.end()) kinds_.push_back(codePoint);
  }

  Warning warningOfOtherLines() const {
    const std::size_t more = otherLines_ - std::min(otherLines_, kMostQuotedLines);
    return {fmt::format("found text that is not UTF-8 and read it as Windows-1252: {}{}", quotes_,
                        more > 0 ? fmt::format(" and {} more lines", more) : ""),
            {file_, firstOtherLine_},
            WarningTopic::kText};
  }

  Warning warningOfReplaced() const {
    std::string kinds;
    for (std::size_t i = 0; i < std::min(kinds_.size(), kMostNamedCharacters); ++i)
      kinds += fmt::format("{}U+{:04X}", i > 0 ? ", " : "", static_cast<std::uint32_t>(kinds_[i]));
    if (kinds_.size() > kMostNamedCharacters) kinds += ", ...";
    return {
        fmt::format("found {} {} ({}) and read {} as {}", replaced_,
                    replaced_ == 1 ? "odd blank or control character" : "odd blanks or control characters",
                    kinds, replaced_ == 1 ? "it" : "them", replaced_ == 1 ? "a blank" : "blanks"),
        firstReplaced_, WarningTopic::kText};
  }

  std::string_view rest_;
  std::string file_;
  std::string text_;
  std::size_t line_ = 1;
  std::size_t otherLines_ = 0;  ///< Lines that are not UTF-8.
  std::size_t firstOtherLine_ = 0;
  std::string quotes_;  ///< What the first of them say.
  std::size_t replaced_ = 0;
  Place firstReplaced_;
  std::vector<char32_t> kinds_;  ///< Code points that were replaced, each once.
  bool hasControls_ = false;
};

/// The bytes without padding at their end, which is told.
std::string_view withoutPadding(std::string_view bytes, std::string_view file, Warnings& warnings) {
  std::string_view content = bytes;
  while (!content.empty() && kPadding.find(content.back()) != std::string_view::npos)
    content.remove_suffix(1);
  const std::size_t left = bytes.size() - content.size();
  if (left > 0) {
    warnings.push_back({fmt::format("left out {} {} of 0 or Ctrl-Z at the end of the file", left,
                                    left == 1 ? "byte" : "bytes"),
                        {std::string(file)},
                        WarningTopic::kText});
  }
  return content;
}

/// A text of its own in which all is plain, or told in a warning.
Result<BvhText> cleaned(std::string_view bytes, std::string_view file, Warnings warnings) {
  if (bytes.find('\0') != std::string_view::npos)
    return refuse("bytes of 0 as in binary files, but no text", file);
  LineDecoder decoder(bytes, file);
  BvhText text(decoder.decode());
  if (decoder.hasControls() && !BvhScanner(text.view(), file).takeWord("HIERARCHY"))
    return refuse("control characters as in binary files, but no text", file);
  text.warnings = std::move(warnings);
  for (Warning& warning : decoder.warnings()) text.warnings.push_back(std::move(warning));
  return text;
}

Result<BvhText> decodeBytes(std::string_view bytes, std::string_view file) {
  const std::string_view marked = bytes.starts_with(kUtf8Mark) ? bytes.substr(kUtf8Mark.size()) : bytes;
  if (const std::string_view content = otherContentIn(marked); !content.empty())
    return refuse(fmt::format("what seems to be {}", content), file);
  Warnings warnings;
  const std::string_view content = withoutPadding(marked, file, warnings);
  if (content.empty()) return refuse(marked.empty() ? "an empty file" : "bytes of 0 alone", file);
  if (!isPlain(content)) return cleaned(content, file, std::move(warnings));
  BvhText text(content);
  text.warnings = std::move(warnings);
  return text;
}

Result<BvhText> decodeUtf16(std::string_view bytes, ByteOrder order, std::string_view file) {
  const bool isLittle = order == ByteOrder::kLittleEndian;
  Utf16Text utf16 = utf8FromUtf16(bytes, order);
  Warnings warnings;
  const auto warn = [&](std::string message) {
    warnings.push_back({std::move(message), {std::string(file)}, WarningTopic::kText});
  };
  if (!bytes.starts_with(isLittle ? "\xFF\xFE" : "\xFE\xFF"))
    warn(fmt::format("read the text as UTF-16 ({}-endian), though it has no byte-order mark",
                     isLittle ? "little" : "big"));
  if (utf16.loneSurrogates > 0)
    warn(fmt::format("read UTF-16 surrogates without their other half ({} in all) as U+FFFD",
                     utf16.loneSurrogates));
  if (utf16.hasHalfUnit) warn("left out the last byte, which is half of a UTF-16 character");
  if (const std::string_view content = otherContentIn(utf16.utf8); !content.empty())
    return refuse(fmt::format("what seems to be {} in UTF-16", content), file);
  const std::string_view content = withoutPadding(utf16.utf8, file, warnings);
  if (content.empty()) return refuse("an empty file", file);
  utf16.utf8.resize(content.size());
  if (!isPlain(utf16.utf8)) return cleaned(utf16.utf8, file, std::move(warnings));
  BvhText text(std::move(utf16.utf8));
  text.warnings = std::move(warnings);
  return text;
}

}  // namespace

Result<BvhText> decodeBvhText(std::string_view bytes, std::string_view file) {
  if (bytes.empty()) return refuse("an empty file", file);
  if (bytes.size() > kMostBvhBytes) {
    return fail(ErrorCode::kBvhValue,
                fmt::format("found a file of {} bytes, expected at most {}", bytes.size(), kMostBvhBytes),
                {std::string(file)});
  }
  switch (encodingOf(bytes)) {
    case BvhEncoding::kUtf16LittleEndian:
      return decodeUtf16(bytes, ByteOrder::kLittleEndian, file);
    case BvhEncoding::kUtf16BigEndian:
      return decodeUtf16(bytes, ByteOrder::kBigEndian, file);
    case BvhEncoding::kUtf32:
      return refuse("text in UTF-32, which is not read", file);
    case BvhEncoding::kBytes:
      break;
  }
  return decodeBytes(bytes, file);
}

}  // namespace stridegraph
