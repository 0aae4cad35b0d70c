#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Land that is told by who lives on it and what it is used for, and asides of the speaker.
namespace latticeworld {
namespace {

// "People live on both banks": houses lie there. "Let cows graze the other three", "the former is
// under the plough": pasture, farmland.
void TurnUsers(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at), next = WordAt(*tokens, at + 1);
  if (IsOneOf(word, {"people", "folk", "villagers"}) && IsOneOf(next, {"live", "dwell"}) &&
      !IsOneOf(at > 0 ? WordAt(*tokens, at - 1) : "", {"no", "where", "many"})) {
    ReplaceTokens(tokens, at, 2, {"houses", "lie"});
    return;
  }
  if (IsOneOf(word, {"let", "have"}) &&
      IsOneOf(next, {"cows", "sheep", "cattle", "horses", "goats"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"graze", "grazing"})) {
    const std::size_t in = IsOneOf(WordAt(*tokens, at + 3), {"in", "on"}) ? 1 : 0;
    ReplaceTokens(tokens, at, 3 + in, {"meadow", "fills"});
    return;
  }
  if (word == "under" && next == "the" && IsOneOf(WordAt(*tokens, at + 2), {"plough", "plow"}))
    ReplaceTokens(tokens, at, 3, {"farmland"});
}

// "(You can) forget about forests": no forests. "Forget about the forest" takes back what was said
// and stays.
void TurnForgotten(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "forget") return;
  // "Do not forget trees around the lake": trees around the lake.
  if (at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"not", "never"})) {
    const std::size_t begin = at - (at > 1 && WordAt(*tokens, at - 2) == "do" ? 2 : 1);
    const std::size_t end = at + (WordAt(*tokens, at + 1) == "about" ? 2 : 1);
    EraseTokens(tokens, begin, end - begin);
    return;
  }
  const std::size_t noun = at + (WordAt(*tokens, at + 1) == "about" ? 2 : 1);
  if (MatchClassWord(*tokens, noun).tokens == 0) return;
  std::size_t begin = at;
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"can", "may", "could"})) --begin;
  if (begin > 0 && begin < at && IsOneOf(WordAt(*tokens, begin - 1), {"you", "we"})) --begin;
  ReplaceTokens(tokens, begin, noun - begin, {"no"});
}

// "From the west and not, as in your last draft, from the east": the aside says nothing of the
// land.
void TurnDrafts(std::vector<Token>* tokens, std::size_t at) {
  const auto is_comma = [&](std::size_t i) {
    return i < tokens->size() && (*tokens)[i].kind == TokenKind::kComma;
  };
  if (!is_comma(at) || WordAt(*tokens, at + 1) != "as" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"in", "on", "you", "we", "i", "it", "last", "before"})) {
    return;
  }
  const std::size_t end = PauseAfter(*tokens, at + 1);
  if (!is_comma(end) || NamesThing(*tokens, at + 2)) return;
  // Where it came from then is not where it comes from now.
  if (at > 1 && WordAt(*tokens, at - 1) == "not" && WordAt(*tokens, end + 1) == "from") {
    const std::size_t and_not = at - (WordAt(*tokens, at - 2) == "and" ? 2 : 1);
    EraseTokens(tokens, and_not, PauseAfter(*tokens, end + 1) - and_not);
    return;
  }
  EraseTokens(tokens, at, end - at);
}

// "Hardly any green": no green space to speak of.
void TurnGreen(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "green" || at == 0 || !IsPauseAt(*tokens, at + 1)) return;
  if (IsOneOf(WordAt(*tokens, at - 1), {"any", "no", "little", "much", "more", "some", "of"}))
    ReplaceTokens(tokens, at, 1, {"greenery"});
}

// "A ring of cliffs about the lake": around it.
void TurnAbout(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "about" || at == 0) return;
  if (!IsOneOf(WordAt(*tokens, at + 1), {"the", "a", "it", "them", "each"})) return;
  bool ring = false;
  for (std::size_t back = 1; back <= 5 && back <= at && !IsPauseAt(*tokens, at - back); ++back) {
    ring = ring || IsOneOf(WordAt(*tokens, at - back),
                           {"ring", "circle", "belt", "wreath", "loop", "girdle", "collar"});
  }
  if (ring) (*tokens)[at].text = "around";
}

// "Along the top it is snow", where no thing stands that could be it: there is snow.
void TurnItIs(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "it" || WordAt(*tokens, at + 1) != "is" || at == 0) return;
  if (SideWord(WordAt(*tokens, at - 1)).empty() &&
      !IsOneOf(WordAt(*tokens, at - 1), {"edge", "corner", "side", "half", "middle", "center"})) {
    return;
  }
  std::size_t begin = SentenceBegin(*tokens, at);
  if (NamesThing(*tokens, begin)) return;
  const bool thing = MatchClassWord(*tokens, at + 2).tokens > 0 ||
                     (IsOneOf(WordAt(*tokens, at + 2), {"a", "all", "mostly", "only", "just"}) &&
                      NamesThing(*tokens, at + 2));
  if (!thing) return;
  (*tokens)[at].text = "there";
}

// "From one side of the map to the other side": to the other. "The nearest stream": the stream. "On
// the left hand and on the right": on both sides. "A loop lane": a loop road.
void TurnNearly(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at), next = WordAt(*tokens, at + 1);
  if (word == "other" && IsOneOf(next, {"side", "edge", "end"}) && at > 3 &&
      WordAt(*tokens, at - 1) == "the" && WordAt(*tokens, at - 2) == "to") {
    for (std::size_t back = 3; back < 9 && back < at; ++back) {
      if (WordAt(*tokens, at - back) != next || WordAt(*tokens, at - back - 1) != "one") continue;
      EraseTokens(tokens, at + 1, 1);
      return;
    }
  }
  if (IsOneOf(word, {"nearest", "closest"}) && at > 0 &&
      IsOneOf(WordAt(*tokens, at - 1), {"the", "its"}) &&
      MatchClassWord(*tokens, at + 1).tokens > 0) {
    EraseTokens(tokens, at, 1);
    return;
  }
  if (word == "on" && next == "the" && WordAt(*tokens, at + 2) == "left" &&
      WordAt(*tokens, at + 3) == "hand" && WordAt(*tokens, at + 4) == "and") {
    std::size_t end = at + 5;
    while (IsOneOf(WordAt(*tokens, end), {"on", "the"})) ++end;
    if (WordAt(*tokens, end) != "right") return;
    ++end;
    if (WordAt(*tokens, end) == "hand") ++end;
    ReplaceTokens(tokens, at, end - at, {"on", "both", "sides"});
    return;
  }
  if (IsOneOf(word, {"ring", "loop", "circular", "orbital"}) &&
      (at == 0 || WordAt(*tokens, at - 1) != "closed") &&
      IsOneOf(next, {"lane", "street", "track", "path", "trail", "highway", "motorway"})) {
    (*tokens)[at].text = "ring";
    (*tokens)[at + 1].text = "road";
  }
}

// "The infield is sand": inside the loop there is sand. "Neither rock has trees": the rock has no
// trees.
void TurnInfield(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "infield") {
    const std::size_t the = at > 0 && WordAt(*tokens, at - 1) == "the" ? 1 : 0;
    const bool is = IsOneOf(WordAt(*tokens, at + 1), {"is", "has", "holds"}) ||
                    (at + 1 < tokens->size() && (*tokens)[at + 1].text == ":");
    ReplaceTokens(tokens, at - the, the + (is ? 2 : 1), {"inside", "the", "loop", "there", "is"});
    return;
  }
  if (WordAt(*tokens, at) != "neither") return;
  const std::size_t verb = at + 1 + MatchClassWord(*tokens, at + 1).tokens;
  if (verb == at + 1 || !IsOneOf(WordAt(*tokens, verb), {"has", "carries", "bears", "holds"}) ||
      MatchClassWord(*tokens, verb + 1).tokens == 0) {
    return;
  }
  ReplaceTokens(tokens, verb, 1, {"has", "no"});
  (*tokens)[at].text = "the";
}

// "One pond, and that is the only water": no other water. "Outside there can be anything you like
// except water": no water.
void TurnOnly(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"that", "this", "it"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"is", "was"}) && WordAt(*tokens, at + 2) == "the" &&
      WordAt(*tokens, at + 3) == "only" && at > 0 &&
      (IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and")) {
    const std::size_t length = MatchClassWord(*tokens, at + 4).tokens;
    bool counted = false;
    for (std::size_t i = at; i > 0 && !IsStopAt(*tokens, i - 1); --i)
      counted = counted || IsOneOf(WordAt(*tokens, i - 1), {"one", "single"});
    if (counted && length > 0 && IsStopAt(*tokens, at + 4 + length)) {
      ReplaceTokens(tokens, at, 4, {"no", "other"});
      return;
    }
  }
  if (WordAt(*tokens, at) != "anything" ||
      (at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"hardly", "scarcely", "barely", "almost"}))) {
    return;
  }
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"you", "one"})) next += 2;
  if (!IsOneOf(WordAt(*tokens, next), {"except", "but"})) return;
  const std::size_t noun = next + 1 + (WordAt(*tokens, next + 1) == "for" ? 1 : 0);
  if (MatchClassWord(*tokens, noun).tokens == 0) return;
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                              {"there", "can", "may", "be", "is", "could", "have", "put", "it"})) {
    --begin;
  }
  ReplaceTokens(tokens, begin, noun - begin, {"no"});
}

// "Follows the line where the two meet": along the border between them. "Layers from the top down":
// from the top down.
void TurnMeetingLine(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"layers", "bands", "stripes", "strips", "rows", "order"}) &&
      WordAt(*tokens, at + 1) == "from" && (at == 0 || IsStopAt(*tokens, at - 1))) {
    EraseTokens(tokens, at, 1);
  }
  if (!IsOneOf(WordAt(*tokens, at), {"line", "border", "seam", "edge"}) ||
      WordAt(*tokens, at + 1) != "where") {
    return;
  }
  std::size_t next = at + 2;
  if (WordAt(*tokens, next) == "the") ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"two", "they", "both"})) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"halves", "parts", "sides"})) ++next;
  if (WordAt(*tokens, next) != "meet" || at < 2) return;
  const std::size_t begin = at - (WordAt(*tokens, at - 1) == "the" ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, begin - 1), {"follows", "along", "on", "follow", "following"}))
    return;
  ReplaceTokens(tokens, begin - 1, next + 1 - begin + 1,
                {"runs", "along", "the", "border", "between", "them"});
}

// "In the middle of nowhere": in the middle. "The east is flat and green": grass. "The left side is
// more forested than the right side": it is forested.
void TurnManners(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  if (word == "nowhere" && at > 1 && WordAt(*tokens, at - 1) == "of" &&
      WordAt(*tokens, at - 2) == "middle") {
    EraseTokens(tokens, at - 1, 2);
    return;
  }
  if (word == "green" && IsPauseAt(*tokens, at + 1) && at > 1) {
    const std::size_t flat =
        WordAt(*tokens, at - 1) == "and" && WordAt(*tokens, at - 2) == "flat" ? at - 2 : at;
    const std::string_view what = flat > 1 ? WordAt(*tokens, flat - 2) : std::string_view();
    const bool land = !SideWord(what).empty() || IsMapWord(what) ||
                      IsOneOf(what, {"half", "part", "side", "third", "rest"});
    if (land && IsOneOf(WordAt(*tokens, flat - 1), {"is", "are"}))
      ReplaceTokens(tokens, flat, at + 1 - flat, {"grass"});
    return;
  }
  if (word != "more" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"forested", "wooded", "rocky", "grassy", "built"})) {
    return;
  }
  const std::size_t than = at + 2 + (WordAt(*tokens, at + 2) == "up" ? 1 : 0);
  if (WordAt(*tokens, than) != "than") return;
  EraseTokens(tokens, than, PauseAfter(*tokens, than) - than);
  EraseTokens(tokens, at, 1);
}

// "Rocks scattered all over the grassland": over it. "No vegetation", "no plants at all": no forest
// and no grass. "A river with rocky banks": with rocks on both banks.
void TurnCover(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at), next = WordAt(*tokens, at + 1);
  if (word == "all" && next == "over" && at > 0 &&
      IsOneOf(WordAt(*tokens, at - 1), {"scattered", "dotted", "strewn", "sprinkled"}) &&
      WordAt(*tokens, at + 2) == "the" && MatchClassWord(*tokens, at + 3).tokens > 0) {
    EraseTokens(tokens, at, 1);
    return;
  }
  if (word == "no" && IsOneOf(next, {"vegetation", "plants", "greenery"}) &&
      (IsPauseAt(*tokens, at + 2) || WordAt(*tokens, at + 2) == "at")) {
    ReplaceTokens(tokens, at + 1, 1, {"forest", "and", "no", "grass"});
    return;
  }
  if (word != "with" || !IsOneOf(WordAt(*tokens, at + 2), {"banks", "shores"})) return;
  const std::string_view land = LandOfAdjective(next);
  if (!land.empty()) ReplaceTokens(tokens, at + 1, 2, {land, "on", "both", "banks"});
}

}  // namespace

void TurnUses(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnUsers(tokens, at);
    TurnForgotten(tokens, at);
    TurnDrafts(tokens, at);
    TurnGreen(tokens, at);
    TurnAbout(tokens, at);
    TurnItIs(tokens, at);
    TurnNearly(tokens, at);
    TurnInfield(tokens, at);
    TurnOnly(tokens, at);
    TurnMeetingLine(tokens, at);
    TurnManners(tokens, at);
    TurnCover(tokens, at);
  }
}

}  // namespace latticeworld
