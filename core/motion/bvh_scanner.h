#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.h"

namespace stridegraph {

/// Steps through a BVH text (BvhText) word by word: blanks and any line ends (LF, CRLF, CR) separate words,
/// and upper and lower case keywords are the same. The text must outlive the scanner. Places are only counted
/// out when something is wrong, so that reading stays fast.
class BvhScanner {
 public:
  /// `file` is the name that messages carry.
  BvhScanner(std::string_view text, std::string_view file);

  /// True when nothing but blanks is left.
  bool atEnd();
  /// True when nothing but blanks is left of the line.
  bool atLineEnd();
  /// Takes `keyword` (upper case) when it is the next whole word.
  bool takeWord(std::string_view keyword);
  /// Takes `symbol` when it comes next.
  bool takeSymbol(char symbol);
  /// Takes what is left of the line or, at its end, the next line that is not blank, up to a "{", without
  /// outer blanks: names may hold blanks. A tab within a name becomes a space. Empty when "{" comes next.
  std::string takeName();
  /// Takes a finite number of at most kLargestBvhNumber in size. A minus sign right behind the digits begins
  /// the next number. `what` says what is expected ("three numbers after OFFSET").
  Result<double> takeNumber(std::string_view what);
  /// Takes a whole number of at most nine digits.
  Result<std::size_t> takeCount(std::string_view what);
  /// The text of the last number that was taken.
  std::string_view lastNumber() const { return lastNumber_; }

  /// Bytes that are not read yet.
  std::size_t remainingBytes() const { return text_.size() - at_; }
  /// Byte at which the next word begins; placeOf() makes a place of it when a message needs one.
  std::size_t offset();
  /// Line and column of a byte. Counts from the beginning of the text: for messages only.
  Place placeOf(std::size_t offset) const;
  /// A kBvhSyntax error at the next word: "found ..., expected `what`". The word is shortened; the message is
  /// UTF-8 whatever the text is.
  tl::unexpected<Error> expected(std::string_view what);

 private:
  void skipBlanks();
  std::string nextWord() const;
  tl::unexpected<Error> badNumber(ErrorCode code, std::string_view what);

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::string_view lastNumber_;
};

}  // namespace stridegraph
