#include "apps/corpus/case.h"

#include <algorithm>
#include <array>

#include "certify/certificate.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_case_bytes = std::size_t{1} << 20;

std::vector<std::string> read_texts(JsonReader& json) {
  std::vector<std::string> texts;
  json.array([&](std::size_t) { texts.emplace_back(json.text()); });
  return texts;
}

// One of a few words, in the named member of the object being read.
template <class Words>
std::string read_word(JsonReader& json, const Words& words) {
  const std::string word(json.text());
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    json.fail(printable(word) + " is not one of those that there are");
  }
  return word;
}

WrongHistory read_wrong(JsonReader& json) {
  static constexpr std::array<std::string_view, 4> names{"file", "class", "kind", "truth"};
  static constexpr std::array<std::string_view, 2> truths{"exact", "recorded"};
  WrongHistory wrong;
  json.object(names, 0b1111, [&](std::size_t member) {
    switch (member) {
      case 0:
        wrong.file = json.text();
        if (!wrong.file.starts_with("wrong/") || wrong.file.find("..") != std::string::npos) {
          json.fail("is not below wrong/");
        }
        break;
      case 1:
        wrong.name = json.text();
        break;
      case 2:
        wrong.kind = read_word(json, fault_names);
        break;
      default:
        wrong.truth = read_word(json, truths);
    }
  });
  return wrong;
}

}  // namespace

CorpusCase parse_case(std::string_view bytes, const std::string& file) {
  static constexpr std::array<std::string_view, 10> names{
      "format", "version", "name",     "family", "tags",
      "story",  "verdict", "instants", "truth",  "wrong"};
  static constexpr std::array<std::string_view, 1> formats{"voroproof-case"};
  static constexpr std::array<std::string_view, 2> verdicts{"certified", "undecided"};
  CorpusCase read;
  read.folder = fs::path(file).parent_path();
  JsonReader json(bytes, file);
  json.object(names, (1u << names.size()) - 1, [&](std::size_t member) {
    switch (member) {
      case 0:
        read_word(json, formats);
        break;
      case 1:
        read_version(json);
        break;
      case 2:
        read.name = json.text();
        if (read.name != read.folder.filename()) json.fail("is not that of the folder");
        break;
      case 3:
        read.family = json.text();
        if (read.family != read.folder.parent_path().filename()) {
          json.fail("is not that of the folder above");
        }
        break;
      case 4:
        read.tags = read_texts(json);
        break;
      case 5:
        read.story = json.text();
        break;
      case 6:
        read.decided = read_word(json, verdicts) == "certified";
        break;
      case 7:
        json.array([&](std::size_t) {
          read.instants.push_back(json.number().value());
          if (read.instants.back() < 0) json.fail("is negative");
        });
        break;
      case 8:
        read.sources = read_texts(json);
        break;
      default:
        json.array([&](std::size_t) { read.wrong.push_back(read_wrong(json)); });
    }
  });
  json.finish();
  return read;
}

namespace {

CorpusCase read_case(const fs::path& folder) {
  const std::string file = (folder / "case.json").string();
  CorpusCase read = parse_case(file_bytes(file, max_case_bytes), file);
  for (const std::string& needed : {read.scene(), read.history()}) {
    if (!fs::is_regular_file(needed)) throw InputError(needed, 0, "", "no such file");
  }
  return read;
}

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_directory() && !entry->path().filename().string().starts_with(".")) {
      found.push_back(entry->path());
    }
  }
  if (error) throw InputError(folder.string(), 0, "", error.message());
  std::sort(found.begin(), found.end());
  return found;
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool has_tag(const CorpusCase& c, const std::string& tag) { return contains(c.tags, tag); }
bool is_of(const CorpusCase& c, const std::string& family) { return c.family == family; }
bool is_named(const CorpusCase& c, const std::string& name) {
  return c.name == name || c.id() == name;
}

// Leaves of the cases those that match one of the words.
template <class Matches>
void select(std::vector<CorpusCase>& cases, const std::vector<std::string>& words, const char* what,
            Matches&& matches) {
  if (words.empty()) return;
  for (const std::string& word : words) {
    if (std::none_of(cases.begin(), cases.end(),
                     [&](const CorpusCase& c) { return matches(c, word); })) {
      throw CorpusError(std::string("no case ") + what + " " + printable(word) +
                        " (`corpus list` shows all)");
    }
  }
  std::erase_if(cases, [&](const CorpusCase& c) {
    return std::none_of(words.begin(), words.end(),
                        [&](const std::string& word) { return matches(c, word); });
  });
}

// Whether a number of the scene is exact text, such as "1/3".
bool has_exact_number(const CorpusCase& c) {
  const std::string scene = file_bytes(c.scene(), max_scene_bytes);
  for (std::size_t k = scene.find('"'); k != std::string::npos; k = scene.find('"', k + 1)) {
    if (k + 1 < scene.size() &&
        std::string_view("+-.0123456789").find(scene[k + 1]) != std::string_view::npos)
      return true;
  }
  return false;
}

}  // namespace

std::string corpus_beside_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  // The program is in build/ or bin/, or in libexec/voroproof/avx2/.
  fs::path folder = program.parent_path();
  for (int level = 0; level < 3; ++level) {
    folder = folder.parent_path();
    for (const char* place : {"corpus/cases", "share/voroproof/corpus/cases"}) {
      const fs::path root = folder / place;
      if (fs::is_directory(root, error)) return root.string();
    }
  }
  return {};
}

std::vector<CorpusCase> find_cases(const std::string& root, const CaseSelection& selection) {
  std::vector<CorpusCase> cases;
  for (const fs::path& family : folders_in(root)) {
    for (const fs::path& folder : folders_in(family)) cases.push_back(read_case(folder));
  }
  if (cases.empty()) throw CorpusError(printable(root, 4096) + ": no cases are there");
  select(cases, selection.families, "of the family", is_of);
  select(cases, selection.tags, "with the tag", has_tag);
  select(cases, selection.names, "named", is_named);
  if (selection.doubles) std::erase_if(cases, has_exact_number);
  return cases;
}

}  // namespace voroproof::internal
