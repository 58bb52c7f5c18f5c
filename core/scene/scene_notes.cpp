#include "scene/scene_notes.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/nearest_name.h"
#include "scene/json_text.h"
#include "scene/scene_limits.h"
#include "scene/scene_members.h"
#include "scene/text_place.h"

namespace stridegraph {
namespace {

/// Letters of a text for the JSON reader, which counts how many have been taken.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

std::string listOf(std::span<const SceneMember> members) {
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::string_view before = i == 0 ? "" : i + 1 == members.size() ? " or " : ", ";
    text += fmt::format("{}{}", before, members[i].name);
  }
  return text;
}

/// A name as messages show it.
std::string shortName(std::string_view name) {
  constexpr std::size_t kLongestShown = 40;
  if (name.size() <= kLongestShown) return std::string(name);
  std::size_t end = kLongestShown;
  // A letter of several bytes is not cut.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return std::string(name.substr(0, end)) + "...";
}

std::string adviceFor(SceneObject object, std::string_view name) {
  std::vector<std::string_view> known;
  for (const SceneMember& member : membersOf(object)) known.push_back(member.name);
  const auto nearest = nearestName(name, known);
  return nearest ? fmt::format("did you mean {}?", *nearest)
                 : fmt::format("expected {}", listOf(membersOf(object)));
}

/// Walks over the text with the kinds of objects that it is in.
class MemberCheck : public nlohmann::json_sax<Json> {
 public:
  MemberCheck(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  std::size_t* taken() { return &taken_; }
  Warnings notes() const;

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool key(string_t& name) override;
  bool start_object(std::size_t) override { return enter(false); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(true); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  /// An object or list that is open at this place of the text.
  struct Level {
    SceneObject object = SceneObject::kNone;  ///< In a list: what its elements are.
    bool isList = false;
    std::string place;
    std::size_t element = 0;
    std::string member;                       ///< The member at hand,
    SceneObject held = SceneObject::kNone;    ///< and what it holds.
    std::set<std::string, std::less<>> seen;  ///< Names so far.
  };
  struct Note {
    SceneObject object;
    std::string member;
    bool isRepeated;
    std::string message;
    std::size_t offset;
    std::size_t others = 0;
  };

  bool value();
  bool enter(bool isList);
  bool leave();
  void add(bool isRepeated, const std::string& member);
  std::size_t keyOffset() const;
  std::string placeOf(const std::string& member) const;

  std::string_view text_;
  std::string_view name_;
  std::size_t taken_ = 0;
  std::vector<Level> levels_;
  std::vector<Note> notes_;
  std::size_t furtherNotes_ = 0;
};

bool MemberCheck::value() {
  if (!levels_.empty() && levels_.back().isList) ++levels_.back().element;
  return true;
}

bool MemberCheck::enter(bool isList) {
  Level next;
  next.isList = isList;
  if (levels_.empty()) {
    next.object = isList ? SceneObject::kNone : SceneObject::kScene;
  } else {
    Level& parent = levels_.back();
    // An object in a list is what the list holds; a list in a list is no part of any scene.
    if (parent.isList)
      next.object = isList ? SceneObject::kNone : parent.object;
    else
      next.object = parent.held;
    next.place =
        parent.isList ? fmt::format("{}[{}]", parent.place, parent.element++) : placeOf(parent.member);
  }
  levels_.push_back(std::move(next));
  return true;
}

bool MemberCheck::leave() {
  levels_.pop_back();
  return true;
}

std::string MemberCheck::placeOf(const std::string& member) const {
  const std::string& place = levels_.back().place;
  return place.empty() ? member : fmt::format("{}.{}", place, member);
}

bool MemberCheck::key(string_t& name) {
  Level& level = levels_.back();
  const SceneMember* const known = findMember(level.object, name);
  level.member = shortName(name);
  level.held = known == nullptr ? SceneObject::kNone : known->holds;
  if (level.object == SceneObject::kNone) return true;
  const bool isFirst = level.seen.insert(name).second;
  if (!isFirst)
    add(true, name);
  else if (known == nullptr)
    add(false, name);
  return true;
}

/// The offset of the name's opening quotation mark: the reader has just taken the closing one. Within a name
/// quotation marks come after an odd number of backslashes.
std::size_t MemberCheck::keyOffset() const {
  std::size_t at = taken_ - 1;
  while (at > 0) {
    --at;
    if (text_[at] != '"') continue;
    std::size_t backslashes = 0;
    while (backslashes < at && text_[at - 1 - backslashes] == '\\') ++backslashes;
    if (backslashes % 2 == 0) return at;
  }
  return 0;
}

void MemberCheck::add(bool isRepeated, const std::string& member) {
  const SceneObject object = levels_.back().object;
  for (Note& note : notes_) {
    if (note.object != object || note.isRepeated != isRepeated || note.member != member) continue;
    ++note.others;
    return;
  }
  if (notes_.size() == kMostSceneNotes) {
    ++furtherNotes_;
    return;
  }
  const std::string place = placeOf(shortName(member));
  std::string message =
      isRepeated ? fmt::format("found {} more than once, the last one counts", place)
                 : fmt::format("found {}, which has no effect; {}", place, adviceFor(object, member));
  notes_.push_back({object, member, isRepeated, std::move(message), keyOffset()});
}

Warnings MemberCheck::notes() const {
  Warnings warnings;
  for (const Note& note : notes_) {
    const std::string others = note.others > 0 ? fmt::format(" (and {} more like it)", note.others) : "";
    warnings.push_back({note.message + others, placeInText(text_, note.offset, name_), WarningTopic::kScene});
  }
  if (furtherNotes_ > 0) {
    warnings.push_back({fmt::format("found {} more members that are not known or given twice", furtherNotes_),
                        {std::string(name_)},
                        WarningTopic::kScene});
  }
  return warnings;
}

}  // namespace

Warnings sceneNotes(std::string_view text, std::string_view name) {
  MemberCheck check(text, name);
  const CountingIterator begin(text.data(), check.taken());
  const CountingIterator end(text.data() + text.size(), check.taken());
  Json::sax_parse(begin, end, &check);
  return check.notes();
}

}  // namespace stridegraph
