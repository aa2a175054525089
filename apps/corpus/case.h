// The cases of the degenerate-case corpus (corpus/README.md has their layout).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "exact/rational.h"

namespace voroproof::internal {

// A wrong history of a case: one edit away from the exact one, or what a named class of faulty
// implementations writes.
struct WrongHistory {
  std::string file;   // below the case's folder
  std::string name;   // name of the class
  std::string kind;   // kind of the fault that the certifier must report (certify/certificate.h)
  std::string truth;  // the truth that it is held against: "exact" or "recorded"
};

struct CorpusCase {
  std::filesystem::path folder;
  std::string name, family;
  std::vector<std::string> tags;
  std::string story;                 // says what is degenerate here and why implementations fail
  bool decided = true;               // else the exact history stops, made to be undecided
  std::vector<Rational> instants;    // at which a diagram is expected
  std::vector<std::string> sources;  // the independent ways in which the history was established
  std::vector<WrongHistory> wrong;

  std::string id() const { return family + "/" + name; }
  std::string path(const std::string& file) const { return (folder / file).string(); }
  std::string scene() const { return path("scene.scene.json"); }
  std::string history() const { return path("exact.history.jsonl"); }
  std::string diagram(std::size_t k) const {
    return path("diagram-" + std::to_string(k) + ".diagram.json");
  }
  std::string picture() const { return path("picture.svg"); }
};

// Which cases are wanted; an empty list asks for all.
struct CaseSelection {
  std::vector<std::string> families, tags, names;  // a name is NAME or FAMILY/NAME
  bool doubles = false;  // only scenes all of whose numbers are JSON numbers, no exact text
};

// The corpus that comes with the program, found beside it: corpus/cases of the source tree that it
// was built in, or share/voroproof/corpus/cases where it is installed. Empty where there is none.
std::string corpus_beside_program();

// The cases below `root` that are wanted, sorted by family and name, which are those of their
// folders. A case belongs to the selection if its family is one of `families`, one of its tags one
// of `tags`, its name one of `names`. Throws InputError where a case is not of the layout
// or `root` cannot be read, CorpusError where there are no cases or an entry of the selection
// names none.
std::vector<CorpusCase> find_cases(const std::string& root, const CaseSelection& selection);

// The case whose case.json has these bytes; `file` is its path, whose folders name the case and its
// family. Whether its other files are there is not looked at. Throws InputError.
CorpusCase parse_case(std::string_view bytes, const std::string& file);

// A selection that cannot be met; what() is one line.
class CorpusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace voroproof::internal
