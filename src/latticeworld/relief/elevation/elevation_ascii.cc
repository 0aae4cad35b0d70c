// Arc/Info ASCII grid, as Esri describes it: pairs of a key and a value, then numbers from the
// north-west row by row. Writers differ in how they mark decimals and what is not known.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation/elevation_format.h"

namespace latticeworld::internal {
namespace {

constexpr char kWhat[] = "the Arc/Info ASCII grid ";
constexpr char kNoData[] = "9e9";  // no ground; short, for it may take the place of a digit
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Words {
 public:
  explicit Words(std::string_view bytes) : rest_(bytes) {}

  // The next one; empty at the end.
  std::string_view Next() {
    std::size_t begin = 0;
    while (begin < rest_.size() && IsSpace(rest_[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest_.size() && !IsSpace(rest_[end])) ++end;
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }

 private:
  std::string_view rest_;
};

// Besides nan and inf: what databases and Microsoft's runtime library write.
bool MeansNothing(std::string_view word) {
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  if (word.empty() || (IsDigit(word[0]) && !StartsWith(word, "1.#"))) return false;
  const std::string name = ToLowerAscii(word.substr(0, 16));
  return name == "null" || StartsWith(name, "1.#inf") || StartsWith(name, "1.#ind") ||
         StartsWith(name, "1.#qnan");
}

// Takes what C's strtod takes in the "C" locale, in decimal; nullopt: no number.
std::optional<double> Parse(std::string_view word) {
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    return exponent != std::string_view::npos && word.substr(exponent + 1, 1) == "-" ? 0.0
                                                                                     : kNothing;
  }
  return std::isfinite(value) ? value : kNothing;
}

// Reads numbers with decimal points or decimal commas, and remembers which there were. The words
// outlive it.
class Numbers {
 public:
  // nullopt: the word is no number. kNothing: it stands for no-data.
  std::optional<double> Read(std::string_view word) {
    if (MeansNothing(word)) return kNothing;
    const std::size_t comma = word.find(',');
    if (comma == std::string_view::npos) {
      text_ = word;
    } else {
      if (comma + 1 == word.size() || !IsDigit(word[comma + 1])) return std::nullopt;
      with_point_.assign(word);
      with_point_[comma] = '.';
      text_ = with_point_;
    }
    const bool plus = text_.size() > 1 && text_[0] == '+' && text_[1] != '-';
    if (plus) text_.remove_prefix(1);
    const std::optional<double> value = Parse(text_);
    if (!value) return std::nullopt;
    if (comma != std::string_view::npos) {
      if (first_comma_.empty()) first_comma_ = word;
    } else if (first_point_.empty() && word.find('.') != std::string_view::npos) {
      first_point_ = word;
    }
    return value;
  }

  // What was read last, with a decimal point, in digits.
  std::string_view text() const { return text_; }

  bool has_commas() const { return !first_comma_.empty(); }
  // Errors: INVALID_ARGUMENT (points and commas).
  Status CheckMarks() const {
    if (first_comma_.empty() || first_point_.empty()) return Status();
    return InvalidArgument(kWhat + ("has decimal points (" + Quote(first_point_)) +
                           ") and decimal commas (" + Quote(first_comma_) +
                           "), so nobody knows what they mean; legal are points, or commas, "
                           "throughout");
  }

 private:
  std::string with_point_;
  std::string_view text_;
  std::string_view first_comma_;
  std::string_view first_point_;
};

struct Header {
  std::int64_t cols = -1;
  std::int64_t rows = -1;
  std::map<std::string, double, std::less<>> values;  // by key in small letters
  std::string_view first;                             // number after it

  bool has(std::string_view key) const { return values.find(key) != values.end(); }
  double at(std::string_view key) const { return values.find(key)->second; }
  // Those of the keys that it has: "xllcorner, yllcenter".
  std::string Present(std::initializer_list<std::string_view> keys) const {
    std::vector<std::string> present;
    for (const std::string_view key : keys) {
      if (has(key)) present.emplace_back(key);
    }
    return Join(present, ", ");
  }
};

// Errors: INVALID_ARGUMENT.
Status AddSide(std::string_view value, const std::string& name, std::int64_t* side) {
  const auto result = std::from_chars(value.data(), value.data() + value.size(), *side);
  if (result.ec == std::errc() && result.ptr == value.data() + value.size()) return Status();
  return InvalidArgument(kWhat + ("has " + name) + " " + Quote(value) + "; legal is 2 to " +
                         std::to_string(kMaxDataSide));
}

Result<Header> ReadHeader(Words* words, Numbers* numbers) {
  constexpr int kMostKeys = 16;
  Header header;
  for (int i = 0; i < kMostKeys; ++i) {
    const std::string_view key = words->Next();
    if (key.empty() || !IsLetter(key[0]) || numbers->Read(key)) {
      header.first = key;
      break;
    }
    std::string name = ToLowerAscii(key);
    if (name == "nodata") name = "nodata_value";
    const std::string_view value = words->Next();
    const std::optional<double> number = numbers->Read(value);
    const bool no_data = name == "nodata_value";
    if (!number || (std::isnan(*number) && !no_data)) {
      return InvalidArgument(kWhat + ("has " + Quote(key)) + " " + Quote(value) +
                             " in its header; legal there is a key and a number" +
                             (no_data ? ", null or nan" : ""));
    }
    if (name == "ncols") LW_RETURN_IF_ERROR(AddSide(value, name, &header.cols));
    if (name == "nrows") LW_RETURN_IF_ERROR(AddSide(value, name, &header.rows));
    if (!header.values.emplace(name, *number).second) {
      return InvalidArgument(kWhat + ("has " + name) + " twice in its header; legal is once");
    }
  }
  if (header.cols < 0 || header.rows < 0) {
    return InvalidArgument(kWhat + std::string(header.cols < 0 ? "has no ncols" : "has no nrows") +
                           " in its header; legal are ncols, nrows, xllcorner, yllcorner, cellsize "
                           "and NODATA_value, each with a number");
  }
  return header;
}

struct Place {
  double west = 0.0;  // of the outer edge
  double south = 0.0;
  double dx = 0.0;  // of a cell
  double dy = 0.0;
};

// Errors: INVALID_ARGUMENT (no size of a cell, two, or none above 0).
Status FindCellSize(const Header& header, Place* place) {
  const bool square = header.has("cellsize");
  const bool dx = header.has("dx"), dy = header.has("dy");
  if (square ? dx || dy : !(dx && dy)) {
    const std::string present = header.Present({"cellsize", "dx", "dy"});
    return InvalidArgument(kWhat + ("has " + (present.empty() ? "no cellsize" : present)) +
                           " in its header; legal is cellsize, or dx with dy");
  }
  for (const char* key : {"cellsize", "dx", "dy"}) {
    if (!header.has(key) || header.at(key) > 0.0) continue;
    return InvalidArgument(kWhat + ("has " + std::string(key)) + " " +
                           FormatDouble(header.at(key)) + " in its header; legal is above 0");
  }
  place->dx = header.at(square ? "cellsize" : "dx");
  place->dy = header.at(square ? "cellsize" : "dy");
  return Status();
}

// Errors: INVALID_ARGUMENT (not a corner of both axes, nor a center of both).
Result<Place> FindPlace(const Header& header) {
  Place place;
  LW_RETURN_IF_ERROR(FindCellSize(header, &place));
  const std::string present = header.Present({"xllcorner", "xllcenter", "yllcorner", "yllcenter"});
  if (present == "xllcorner, yllcorner") {
    place.west = header.at("xllcorner");
    place.south = header.at("yllcorner");
    return place;
  }
  if (present == "xllcenter, yllcenter") {
    place.west = header.at("xllcenter") - 0.5 * place.dx;
    place.south = header.at("yllcenter") - 0.5 * place.dy;
    return place;
  }
  return InvalidArgument(
      kWhat + ("has " + (present.empty() ? "neither a corner nor a center" : present)) +
      " in its header, so nobody knows where it lies; legal are xllcorner with yllcorner, or "
      "xllcenter with yllcenter");
}

std::string HeaderText(const Header& header, const Place& place) {
  std::string text = "ncols " + std::to_string(header.cols) + "\nnrows " +
                     std::to_string(header.rows) + "\nxllcorner " + FormatDouble(place.west) +
                     "\nyllcorner " + FormatDouble(place.south);
  if (place.dx == place.dy) {
    text += "\ncellsize " + FormatDouble(place.dx);
  } else {
    text += "\ndx " + FormatDouble(place.dx) + "\ndy " + FormatDouble(place.dy);
  }
  return text + "\nNODATA_value " + kNoData + "\n";
}

// Keys that mean nothing here may have meant something to their writer.
std::vector<std::string> WarningsOf(const Header& header) {
  constexpr std::string_view kKnown[] = {"ncols",     "nrows",       "xllcorner", "xllcenter",
                                         "yllcorner", "yllcenter",   "cellsize",  "dx",
                                         "dy",        "nodata_value"};
  std::vector<std::string> warnings;
  for (const auto& [key, value] : header.values) {
    if (std::find(std::begin(kKnown), std::end(kKnown), key) != std::end(kKnown)) continue;
    warnings.push_back(kWhat + ("has " + Quote(key)) + " " + FormatDouble(value) +
                       " in its header, which is not known and is left out");
  }
  return warnings;
}

// Writes samples, and looks at their heights on the way.
class SampleWriter {
 public:
  // no_data: the value that stands for it; NaN: none is declared.
  SampleWriter(double no_data, ArcAsciiGrid* grid) : no_data_(no_data), grid_(grid) {}

  // digits: of the value.
  void Add(double value, std::string_view digits, char separator) {
    // GDAL reads no longer words.
    constexpr std::size_t kMostDigits = 32;
    if (std::isnan(value) || value == no_data_) {
      grid_->text += kNoData;
    } else {
      if (digits.size() > kMostDigits) {
        grid_->text += FormatDouble(value);
      } else {
        grid_->text += digits;
      }
      Measure(value);
    }
    grid_->text += separator;
  }

 private:
  void Measure(double value) {
    if (value < kLowestGround_m || value > kHighestGround_m) return;
    grid_->whole_numbers = grid_->whole_numbers && value == std::floor(value);
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
    grid_->height_range_m = highest_ - lowest_;
  }

  const double no_data_;
  ArcAsciiGrid* const grid_;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Result<ArcAsciiGrid> NormalizeArcAscii(std::string_view bytes) {
  Words words(bytes);
  Numbers numbers;
  LW_ASSIGN_OR_RETURN(const Header header, ReadHeader(&words, &numbers));
  LW_RETURN_IF_ERROR(CheckDataSize(header.cols, header.rows));
  LW_ASSIGN_OR_RETURN(const Place place, FindPlace(header));
  ArcAsciiGrid grid;
  grid.warnings = WarningsOf(header);
  grid.text = HeaderText(header, place);
  grid.text.reserve(grid.text.size() + bytes.size());
  SampleWriter samples(header.has("nodata_value") ? header.at("nodata_value") : kUsualNoData,
                       &grid);
  const std::int64_t needed = header.cols * header.rows;
  std::int64_t found = 0;
  for (std::string_view word = header.first; !word.empty(); word = words.Next()) {
    ++found;
    const std::optional<double> value = numbers.Read(word);
    if (!value) {
      return InvalidArgument(kWhat + ("has " + Quote(word)) + " in place of number " +
                             std::to_string(found) +
                             "; legal are numbers, and nan, inf or null for no-data");
    }
    LW_RETURN_IF_ERROR(numbers.CheckMarks());
    if (found > needed) break;
    samples.Add(*value, numbers.text(), found % header.cols == 0 ? '\n' : ' ');
  }
  if (found == needed) {
    if (numbers.has_commas()) {
      grid.warnings.push_back(kWhat + std::string("has decimal commas, which are read as points"));
    }
    return grid;
  }
  return InvalidArgument(kWhat + ("of " + std::to_string(header.cols)) + " x " +
                         std::to_string(header.rows) + " samples needs " + std::to_string(needed) +
                         " numbers and has " +
                         (found > needed ? "more" : std::to_string(found) + ": it is cut off"));
}

}  // namespace latticeworld::internal
