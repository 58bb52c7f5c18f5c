#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace stridegraph::tools {

/// A text of unknown origin, such as a file's name, as messages and reports hold it: valid UTF-8 without
/// control characters, which become U+FFFD.
std::string shownText(std::string_view bytes);

/// What a user typed, as messages quote it: shown, in quotation marks where it is empty or has blanks, and
/// cut when it is long.
std::string quotedText(std::string_view bytes);

/// Writes a text to a terminal or file as UTF-8, lines and tabs kept, other control characters as U+FFFD.
/// What cannot be written is left to finishOutput().
void print(std::FILE* stream, std::string_view text);

/// The same with the end of a line.
void printLine(std::FILE* stream, std::string_view text);

/// Writes out all that was printed to standard output; false when some of it could not be written.
bool finishOutput();

}  // namespace stridegraph::tools
