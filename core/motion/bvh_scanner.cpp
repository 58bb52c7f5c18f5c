#include "motion/bvh_scanner.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/utf8.h"
#include "motion/bvh_limits.h"

namespace stridegraph {
namespace {

constexpr std::size_t kMostDigits = 9;
constexpr std::size_t kQuotedBytes = 40;

bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}

/// Letters beyond ASCII count as such, whichever they are.
bool isWordCharacter(char c) {
  return static_cast<unsigned char>(c) >= 0x80U || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
         (c >= 'a' && c <= 'z') || c == '_';
}

char upperCase(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool isContinuationByte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

BvhScanner::BvhScanner(std::string_view text, std::string_view file) : text_(text), file_(file) {}

void BvhScanner::skipBlanks() {
  while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
}

bool BvhScanner::atEnd() {
  skipBlanks();
  return at_ == text_.size();
}

bool BvhScanner::atLineEnd() {
  while (at_ < text_.size() && isBlank(text_[at_]) && !isLineEnd(text_[at_])) ++at_;
  return at_ == text_.size() || isLineEnd(text_[at_]);
}

bool BvhScanner::takeWord(std::string_view keyword) {
  skipBlanks();
  if (remainingBytes() < keyword.size()) return false;
  for (std::size_t i = 0; i < keyword.size(); ++i) {
    if (upperCase(text_[at_ + i]) != keyword[i]) return false;
  }
  const std::size_t end = at_ + keyword.size();
  if (end < text_.size() && isWordCharacter(text_[end])) return false;
  at_ = end;
  return true;
}

bool BvhScanner::takeSymbol(char symbol) {
  skipBlanks();
  if (at_ == text_.size() || text_[at_] != symbol) return false;
  ++at_;
  return true;
}

std::string BvhScanner::takeName() {
  skipBlanks();
  const std::size_t end = std::min(text_.find_first_of("\r\n{", at_), text_.size());
  std::string_view name = text_.substr(at_, end - at_);
  while (!name.empty() && isBlank(name.back())) name.remove_suffix(1);
  at_ += name.size();
  std::string plain(name);
  std::replace_if(plain.begin(), plain.end(), isBlank, ' ');
  return plain;
}

Result<double> BvhScanner::takeNumber(std::string_view what) {
  skipBlanks();
  const char* const end = text_.data() + text_.size();
  const char* const begin = text_.data() + at_;
  const bool hasPlus = begin != end && *begin == '+';
  double value = 0.0;
  const fast_float::from_chars_result read =
      fast_float::from_chars(begin + (hasPlus ? 1 : 0), end, value, fast_float::chars_format::general);
  if (read.ec != std::errc() || (hasPlus && begin[1] == '-')) return badNumber(ErrorCode::kBvhSyntax, what);
  const bool isSeparated =
      read.ptr == end || isBlank(*read.ptr) || *read.ptr == '-' || *read.ptr == '+' || *read.ptr == '}';
  if (!isSeparated) return badNumber(ErrorCode::kBvhSyntax, what);
  if (!std::isfinite(value)) return badNumber(ErrorCode::kBvhValue, what);
  if (std::abs(value) > kLargestBvhNumber) return badNumber(ErrorCode::kBvhValue, what);
  lastNumber_ = text_.substr(at_, static_cast<std::size_t>(read.ptr - begin));
  at_ += lastNumber_.size();
  return value;
}

Result<std::size_t> BvhScanner::takeCount(std::string_view what) {
  skipBlanks();
  std::size_t count = 0;
  std::size_t end = at_;
  for (; end < text_.size() && text_[end] >= '0' && text_[end] <= '9'; ++end) {
    if (end - at_ == kMostDigits) {
      return fail(ErrorCode::kBvhValue,
                  fmt::format("found {}, expected {} of at most {} digits", nextWord(), what, kMostDigits),
                  placeOf(at_));
    }
    count = count * 10 + static_cast<std::size_t>(text_[end] - '0');
  }
  const bool isSeparated = end == text_.size() || isBlank(text_[end]);
  if (end == at_ || !isSeparated) return expected(what);
  at_ = end;
  return count;
}

std::size_t BvhScanner::offset() {
  skipBlanks();
  return at_;
}

Place BvhScanner::placeOf(std::size_t offset) const {
  Place place{file_, 1, 1};
  for (std::size_t i = 0; i < offset; ++i) {
    const bool endsLine =
        text_[i] == '\n' || (text_[i] == '\r' && (i + 1 >= text_.size() || text_[i + 1] != '\n'));
    if (endsLine) {
      ++place.line;
      place.column = 1;
    } else if (!isContinuationByte(text_[i])) {
      ++place.column;
    }
  }
  return place;
}

tl::unexpected<Error> BvhScanner::expected(std::string_view what) {
  skipBlanks();
  return fail(ErrorCode::kBvhSyntax, fmt::format("found {}, expected {}", nextWord(), what),
              placeOf(offset()));
}

std::string BvhScanner::nextWord() const {
  if (at_ == text_.size()) return "the end of the text";
  std::size_t end = at_;
  while (end < text_.size() && !isBlank(text_[end])) ++end;
  std::string word(text_.substr(at_, end - at_));
  const bool isLong = word.size() > kQuotedBytes;
  if (isLong) {
    std::size_t cut = kQuotedBytes;
    while (cut > 0 && isContinuationByte(word[cut])) --cut;
    word.resize(cut);
  }
  for (char& c : word) {
    if (static_cast<unsigned char>(c) < 0x20U || c == '\x7F') c = '?';
  }
  return fmt::format("\"{}{}\"", toUtf8(word), isLong ? "..." : "");
}

tl::unexpected<Error> BvhScanner::badNumber(ErrorCode code, std::string_view what) {
  const std::string found = nextWord();
  std::string_view hint;
  if (code == ErrorCode::kBvhValue)
    hint = ", finite and at most 1e9 in size";
  else if (found.find(',') != std::string::npos)
    hint = ", with a decimal point, and blanks between numbers";
  return fail(code, fmt::format("found {}, expected {}{}", found, what, hint), placeOf(offset()));
}

}  // namespace stridegraph
