#include "apps/cli/help.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/parser.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::vector<std::string> words;
  bool json = false;
};

Json described(const Option& option) {
  Json json = Json::object();
  json["names"] = option.names;
  json["help"] = option.help;
  json["type"] = option.type;
  json["values"] = option.is_flag() ? 0 : option.values;
  json["required"] = option.is_required;
  json["repeats"] = option.repeats;
  if (!option.initial.empty()) json["default"] = option.initial;
  if (!option.choices.empty()) json["choices"] = option.choices;
  if (!option.excluded.empty()) json["excludes"] = option.excluded;
  if (!option.needed.empty()) json["needs"] = option.needed;
  return json;
}

Json described(const Verb& verb) {
  Json json = Json::object();
  json["name"] = verb.name();
  json["description"] = verb.description();
  json["arguments"] = json["options"] = json["verbs"] = Json::array();
  for (const Option& option : verb.options()) {
    json[option.is_argument() ? "arguments" : "options"].push_back(described(option));
  }
  json["notes"] = verb.notes();
  json["examples"] = verb.examples();
  for (const Verb& below : verb.verbs()) json["verbs"].push_back(described(below));
  return json;
}

ExitCode help(Verb& program, const Request& request) {
  if (!request.json) {
    std::cout << help_text(program, request.words);
    return ExitCode::ok;
  }
  if (!request.words.empty()) throw UsageError("--json: describes all verbs; name none");
  Json json = {{"format", "voroproof-help"}, {"version", 1}, {"producer", producer()}};
  json.update(described(program));
  std::cout << json.dump(2) << '\n';
  return ExitCode::ok;
}

}  // namespace

void add_help(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("help", "Show the help of a verb");
  verb.list("verb", request->words, "NAME", "The verb, and a verb below it: query voids.");
  verb.flag("--json", request->json,
            "Describe all verbs with their arguments and options as JSON.");
  verb.example("voroproof help query voids");
  verb.does([request, &program] { return help(program, *request); });
}

}  // namespace voroproof::internal
