#include "history/disk_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "history/error.h"
#include "history/line_source.h"

namespace voroproof::internal {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 16;
constexpr std::size_t most_disks = 100'000'000;
constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(x)) return {};
  return x;
}

// Which column of the three a name means, or -1.
int meaning(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  static const std::vector<std::string> known[] = {{"x", "lon", "lng", "longitude", "easting"},
                                                   {"y", "lat", "latitude", "northing"},
                                                   {"radius", "r", "weight", "w"}};
  for (int k = 0; k < 3; ++k) {
    if (std::find(known[k].begin(), known[k].end(), name) != known[k].end()) return k;
  }
  return -1;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), lines_(path) {}

  DiskTable read() {
    lines_.keep_digest();
    bool first = true;
    while (const auto line = lines_.next(longest_line)) {
      const std::string_view text = trimmed(*line);
      if (text.empty() || text.front() == '#') continue;
      if (first) {
        choose_separator(text);
        first = false;
        if (take_heading(fields(text))) continue;
      }
      take_row(fields(text));
    }
    table_.sha256 = lines_.content_sha256();
    return std::move(table_);
  }

 private:
  void choose_separator(std::string_view line) {
    for (const char c : {',', ';', '\t'}) {
      if (separator_ == ' ' && line.find(c) != std::string_view::npos) separator_ = c;
    }
  }

  std::vector<std::string> fields(std::string_view line) const {
    std::vector<std::string> all;
    while (true) {
      if (separator_ == ' ') line = trimmed(line);
      std::string field;
      std::size_t end = 0;
      const std::string_view rest = trimmed(line);
      if (rest.starts_with('"')) {
        // A quote within quotes stands twice.
        std::size_t k = line.find('"') + 1;
        for (; k < line.size() && (line[k] != '"' || line.substr(k, 2) == "\"\""); ++k) {
          field += line[k];
          if (line[k] == '"') ++k;
        }
        if (k >= line.size()) fail("", "a quote is not closed");
        end = line.find(separator_, k + 1);
        if (!trimmed(line.substr(k + 1, end - k - 1)).empty()) fail("", "text behind a quote");
      } else {
        end = line.find(separator_);
        field = trimmed(line.substr(0, end));
      }
      all.push_back(std::move(field));
      if (end == std::string_view::npos) return all;
      line.remove_prefix(end + 1);
    }
  }

  // Whether these are names of columns.
  bool take_heading(const std::vector<std::string>& names) {
    size_ = names.size();
    if (std::all_of(names.begin(), names.end(), [](const auto& n) { return number_in(n); })) {
      if (size_ != 2 && size_ != 3) fail("", "no heading, and not two or three numbers");
      columns_ = {0, 1, size_ == 3 ? 2 : -1};
      return false;
    }
    for (std::size_t k = 0; k < size_; ++k) {
      const int what = meaning(names[k]);
      if (what < 0) {
        table_.rest.push_back({names[k], {}});
        rest_.push_back(k);
        continue;
      }
      if (columns_[what] >= 0) fail(names[k], "a second column of this meaning");
      columns_[what] = static_cast<int>(k);
    }
    if (columns_[0] < 0) fail("x", "this column is missing");
    if (columns_[1] < 0) fail("y", "this column is missing");
    return true;
  }

  void take_row(const std::vector<std::string>& row) {
    if (row.size() != size_) {
      fail("", std::to_string(row.size()) + " fields, not " + std::to_string(size_));
    }
    if (table_.disks.size() == most_disks) fail("", "too many disks");
    table_.disks.push_back(
        {number(row, 0, "x"), number(row, 1, "y"), columns_[2] < 0 ? 0 : number(row, 2, "radius")});
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      table_.rest[k].second.push_back(row[rest_[k]]);
    }
  }

  double number(const std::vector<std::string>& row, int what, const char* name) const {
    const auto x = number_in(row[columns_[what]]);
    if (!x) fail(name, "not a finite decimal number");
    if (*x != 0 && (std::fabs(*x) > 1e100 || std::fabs(*x) < 1e-100)) {
      fail(name, "beyond 1e-100 to 1e100 in magnitude");
    }
    return *x;
  }

  [[noreturn]] void fail(const std::string& field, const std::string& reason) const {
    throw InputError(path_, lines_.number(), field, reason);
  }

  std::string path_;
  LineSource lines_;
  char separator_ = ' ';
  std::size_t size_ = 0;
  std::vector<int> columns_{-1, -1, -1};  // where x, y and radius are
  std::vector<std::size_t> rest_;
  DiskTable table_;
};

}  // namespace

DiskTable read_disk_table(const std::string& path) { return Reader(path).read(); }

}  // namespace voroproof::internal
