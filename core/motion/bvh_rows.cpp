#include "motion/bvh_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "motion/bvh_limits.h"

namespace stridegraph {
namespace {

/// A digit and what separates it from the next number; a minus sign may be that.
constexpr std::size_t kBytesOfShortestNumber = 2;

std::size_t distanceBetween(std::size_t a, std::size_t b) {
  return a < b ? b - a : a - b;
}

/// A line of numbers.
struct Line {
  std::size_t offset = 0;  ///< Of its first number in the text.
  std::size_t numbers = 0;
};

/// Lines since the last whole row.
struct OpenRow {
  Line first;
  std::size_t numbers = 0;
  std::size_t lines = 0;
};

class RowsParser {
 public:
  RowsParser(BvhScanner& scanner, const BvhRowShape& shape) : scanner_(scanner), shape_(shape) {}

  Result<BvhRows> parse() {
    // The text may hold fewer numbers than were declared.
    const std::size_t most = (scanner_.remainingBytes() + 1) / kBytesOfShortestNumber;
    rows_.values.reserve(std::min({most, shape_.declared * shape_.columns, kMostBvhNumbers}));
    while (!scanner_.atEnd()) {
      const Result<bool> taken = takeLine();
      if (!taken) return tl::unexpected(taken.error());
      if (!*taken) break;
    }
    if (Result<void> checked = checkCounts(); !checked) return tl::unexpected(std::move(checked.error()));
    warnOfCounts();
    rows_.values.resize(rowCount() * shape_.columns);
    return std::move(rows_);
  }

 private:
  std::size_t rowCount() const { return rows_.values.size() / shape_.columns; }
  std::size_t numbersLeft() const { return rows_.values.size() % shape_.columns; }

  /// False when the rows have ended and other text follows.
  Result<bool> takeLine() {
    std::vector<double>& values = rows_.values;
    const std::size_t begin = values.size();
    const std::size_t offset = scanner_.offset();
    while (!scanner_.atLineEnd()) {
      const Result<double> value = scanner_.takeNumber("a channel's value");
      if (!value) {
        if (values.size() > begin || open_.lines > 0 || rowCount() < shape_.declared)
          return tl::unexpected(value.error());
        warn("left out the text behind the last frame, which begins here", offset);
        return false;
      }
      if (values.size() == kMostBvhNumbers)
        return failAtLimit("numbers in all rows", kMostBvhNumbers, scanner_.offset());
      values.push_back(*value);
    }
    if (Result<void> ended = endLine({offset, values.size() - begin}); !ended)
      return tl::unexpected(std::move(ended.error()));
    return true;
  }

  Result<void> endLine(const Line& line) {
    ++lines_;
    if (open_.lines == 0) open_.first = line;
    open_.numbers += line.numbers;
    ++open_.lines;
    const bool isWhole = open_.numbers % shape_.columns == 0;
    const bool endsWithinALine = open_.numbers > shape_.columns && !(isWhole && open_.lines == 1);
    if (endsWithinALine && !isCutLine()) return failMisfit(line);
    return isWhole ? endRows(line) : Result<void>();
  }

  /// True for a last line of several whole rows and a cut one. All on one line may also be rows of a wrong
  /// length; then each declared frame has equally many numbers.
  bool isCutLine() {
    if (open_.lines > 1 || rowCount() > shape_.declared || !scanner_.atEnd()) return false;
    return lines_ == 1 ? rows_.values.size() % shape_.declared != 0 : hasLinesOfSeveralRows_;
  }

  /// Whole rows have ended with this line.
  Result<void> endRows(const Line& line) {
    hasLinesOfSeveralRows_ |= open_.numbers > shape_.columns;
    if (!oddLine_ && (open_.lines > 1 || open_.numbers > shape_.columns)) oddLine_ = open_.first;
    open_ = {};
    if (rowCount() > shape_.declared && !offsetOfMore_) offsetOfMore_ = line.offset;
    if (rowCount() > kMostBvhFrames) return failAtLimit("rows", kMostBvhFrames, line.offset);
    if (rowCount() > kMostBvhRotations / shape_.joints)
      return failAtLimit("rotations, rows times joints,", kMostBvhRotations, line.offset);
    return {};
  }

  /// Names the line at fault where a row ends within a line.
  tl::unexpected<Error> failMisfit(const Line& line) {
    const bool isAll = lines_ == 1 && line.numbers % shape_.declared == 0 && scanner_.atEnd();
    if (isAll) return failRow({line.offset, line.numbers / shape_.declared});
    if (open_.lines == 1) return failRow(line);
    const bool isWhole = line.numbers % shape_.columns == 0;
    const Line before{open_.first.offset, open_.numbers - line.numbers};
    if (isWhole && open_.lines > 2) return failLines(before, open_.lines - 1);
    // A line that is a row, or no row wrapped so far: the line before it is no part of a wrapped row either.
    if (open_.lines == 2 && (isWhole || !oddLine_)) return failRow(before);
    return failLines({open_.first.offset, open_.numbers}, open_.lines);
  }

  /// Rows of a wrong length may add up to whole ones; then lines are as many as declared frames, and rows are
  /// not.
  Result<void> checkCounts() {
    const std::size_t rows = rowCount() + (numbersLeft() > 0 ? 1 : 0);
    const bool linesAreFrames =
        distanceBetween(lines_, shape_.declared) < distanceBetween(rows, shape_.declared);
    if (rowCount() == 0 && lines_ > 1)
      return linesAreFrames ? failRow(open_.first)
                            : failLines({open_.first.offset, open_.numbers}, open_.lines);
    if (rowCount() == 0)
      return scanner_.expected(
          fmt::format("a row of {} numbers, of which {} are there", shape_.columns, numbersLeft()));
    if (oddLine_ && linesAreFrames) return failRow(*oddLine_);
    const std::size_t numbers = rows_.values.size();
    if (lines_ == 1 && numbers % shape_.declared == 0 && numbers / shape_.declared != shape_.columns)
      return failRow({oddLine_ ? oddLine_->offset : open_.first.offset, numbers / shape_.declared});
    return {};
  }

  void warnOfCounts() {
    const std::size_t left = numbersLeft();
    if (rowCount() == shape_.declared && left == 0) return;
    const std::size_t offset = left > 0 ? open_.first.offset : offsetOfMore_.value_or(scanner_.offset());
    warn(fmt::format("{} frames are declared, {} complete rows of {} numbers{} were found; the complete rows "
                     "are used",
                     shape_.declared, rowCount(), shape_.columns,
                     left > 0 ? fmt::format(" and {} more", left) : ""),
         offset);
  }

  void warn(std::string message, std::size_t offset) {
    rows_.warnings.push_back({std::move(message), scanner_.placeOf(offset), WarningTopic::kRows});
  }

  tl::unexpected<Error> failRow(const Line& row) const {
    return fail(ErrorCode::kBvhSyntax,
                fmt::format("found {} numbers in a row, expected {}, one for each channel in HIERARCHY",
                            row.numbers, shape_.columns),
                scanner_.placeOf(row.offset));
  }

  tl::unexpected<Error> failLines(const Line& lines, std::size_t count) const {
    return fail(ErrorCode::kBvhSyntax,
                fmt::format("found {} numbers in {} lines, expected a row of {}, one for each channel in "
                            "HIERARCHY, that ends where a line ends",
                            lines.numbers, count, shape_.columns),
                scanner_.placeOf(lines.offset));
  }

  tl::unexpected<Error> failAtLimit(std::string_view what, std::size_t limit, std::size_t offset) const {
    return fail(ErrorCode::kBvhValue,
                fmt::format("found more {} than the limit, expected at most {}", what, limit),
                scanner_.placeOf(offset));
  }

  BvhScanner& scanner_;
  BvhRowShape shape_;
  BvhRows rows_;
  std::size_t lines_ = 0;  ///< With numbers.
  OpenRow open_;
  /// The first line that is no row: a part of a wrapped row, or several rows.
  std::optional<Line> oddLine_;
  bool hasLinesOfSeveralRows_ = false;
  std::optional<std::size_t> offsetOfMore_;  ///< Of the line with the first row that was not declared.
};

}  // namespace

Result<BvhRows> parseBvhRows(BvhScanner& scanner, const BvhRowShape& shape) {
  return RowsParser(scanner, shape).parse();
}

}  // namespace stridegraph
