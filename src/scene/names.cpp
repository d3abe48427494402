#include "scene/names.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <string_view>

namespace bempd::scene {

namespace {

constexpr std::array<std::string_view, 4> words{"region", "support", "load", "edge"};  // by kind, edges last
constexpr int edge_word = 3;

bool continues_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Whole number in a text, and the position behind it.
struct Numeral {
  int value;
  std::size_t end;
};
// Whole number that stands in a text from `begin` on; empty if there is none, or a number with a fraction.
std::optional<Numeral> numeral_at(std::string_view text, std::size_t begin) {
  int value = 0;
  const char* const first = text.data() + std::min(begin, text.size());
  const auto [last, problem] = std::from_chars(first, text.data() + text.size(), value);
  if (problem != std::errc() || value < 1 || *first == '-') return std::nullopt;
  const auto end = static_cast<std::size_t>(last - text.data());
  if (end < text.size() && continues_word(text[end])) return std::nullopt;
  if (end + 1 < text.size() && text[end] == '.' && text[end + 1] >= '0' && text[end + 1] <= '9') return std::nullopt;
  return Numeral{value, end};
}

// Word for a kind of object in a sentence, such as "loads", with the numbers behind the word and the position where
// each of them ends.
struct Mention {
  int kind;
  std::vector<Numeral> numbers;
};
std::optional<Mention> mention_at(std::string_view text, std::size_t begin) {
  if (begin > 0 && continues_word(text[begin - 1])) return std::nullopt;
  for (int kind = 0; kind < static_cast<int>(words.size()); ++kind) {
    const std::string_view word = words[static_cast<std::size_t>(kind)];
    if (text.substr(begin, word.size()) != word) continue;
    std::size_t at = begin + word.size();
    const bool several = text.substr(at, 1) == "s";
    if (several) ++at;
    if (text.substr(at, 1) != " ") return std::nullopt;
    Mention mention{kind, {}};
    for (std::optional<Numeral> next = numeral_at(text, at + 1); next;) {
      mention.numbers.push_back(*next);
      at = next->end;
      next.reset();
      for (const std::string_view link : {", ", " and ", " or "})
        if (several && !next && text.substr(at, link.size()) == link) next = numeral_at(text, at + link.size());
    }
    if (mention.numbers.empty()) return std::nullopt;
    return mention;
  }
  return std::nullopt;
}

// The only region that a sentence mentions; 0 if it mentions none, or several.
int only_region(std::string_view text) {
  std::set<int> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto mention = mention_at(text, at);
    if (!mention || mention->kind != static_cast<int>(Names::Kind::region)) continue;
    for (const Numeral& number : mention->numbers) found.insert(number.value);
  }
  return found.size() == 1 ? *found.begin() : 0;
}

std::string in_quotes(const std::string& name) { return name.empty() ? name : " (\"" + name + "\")"; }

}  // namespace

void Names::put(const Key& key, std::string name) {
  if (name.empty())
    names_.erase(key);
  else
    names_[key] = std::move(name);
}

const std::string& Names::at(const Key& key) const {
  static const std::string none;
  const auto found = names_.find(key);
  return found == names_.end() ? none : found->second;
}

std::vector<int> Names::edges(int region, const std::string& name) const {
  std::vector<int> found;
  for (auto entry = names_.lower_bound({of_edges, region, 0});
       entry != names_.end() && entry->first[0] == of_edges && entry->first[1] == region; ++entry)
    if (name.empty() || entry->second == name) found.push_back(entry->first[2]);
  return found;
}

std::string Names::called(Kind kind, int number) const {
  return std::string(words[static_cast<std::size_t>(kind)]) + " " + std::to_string(number) +
         in_quotes(of(kind, number));
}

std::string Names::in(const std::string& sentence) const {
  if (empty()) return sentence;
  const std::string_view text = sentence;
  constexpr std::string_view of_region = " of region ";
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::optional<Mention> mention = mention_at(text, begin);
    if (!mention) {
      result += text[begin++];
      continue;
    }
    int region = 0;
    if (mention->kind == edge_word) {
      const std::size_t behind = mention->numbers.back().end;
      const auto owner = text.substr(behind, of_region.size()) == of_region
                             ? numeral_at(text, behind + of_region.size())
                             : std::nullopt;
      region = owner ? owner->value : only_region(text);
    }
    for (const Numeral& number : mention->numbers) {
      result += text.substr(begin, number.end - begin);
      result += in_quotes(mention->kind == edge_word ? of_edge(region, number.value)
                                                     : of(static_cast<Kind>(mention->kind), number.value));
      begin = number.end;
    }
  }
  return result;
}

}  // namespace bempd::scene
