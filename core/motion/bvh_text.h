#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace stridegraph {

/// The text of a BVH file as UTF-8, without byte-order mark. Holds no control characters but tabs and line
/// ends, and of all blanks only those of ASCII. Lines and columns are those of the file.
class BvhText {
 public:
  explicit BvhText(std::string_view bytes) : bytes_(bytes) {}
  explicit BvhText(std::string decoded) : decoded_(std::move(decoded)) {}

  /// Borrows the text, and the file's bytes where these are the text already.
  std::string_view view() const { return decoded_ ? std::string_view(*decoded_) : bytes_; }

  Warnings warnings;

 private:
  std::string_view bytes_;
  std::optional<std::string> decoded_;
};

/// Reads the bytes of a BVH file, which must outlive the result, as text. UTF-8 with or without byte-order
/// mark is taken as it is. UTF-16 is read with a mark, or without where a first word HIERARCHY shows it.
/// Lines that are no UTF-8 are read as Windows-1252, which Latin-1 is a part of. Blanks beyond ASCII (such as
/// U+00A0 and U+3000), U+FEFF within the text and control characters become blanks; bytes of 0 and Ctrl-Z at
/// the end are left out. Each of these but a byte-order mark is told in a warning (WarningTopic::kText).
/// `file` is the name that messages carry. Fails with kBvhSyntax where the content is no text or that of
/// another kind of file, and with kBvhValue where there are more than kMostBvhBytes bytes.
Result<BvhText> decodeBvhText(std::string_view bytes, std::string_view file);

}  // namespace stridegraph
