// The only file that knows the library of the command line: its headers take seconds to compile.
#include "apps/cli/parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <utility>

#include "apps/cli/suggestion.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t column = 32, width = 68;  // where the words of the help begin, and how wide

// The text in lines of no more than so many characters, where its words let it.
std::string wrapped(const std::string& text, std::size_t most) {
  std::string result, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > most) {
      result += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return result + line;
}

// The text that the help shows behind an option's names.
std::string shown_type(const Option& option) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += ' ' + part; };
  if (!option.is_flag()) add(option.type);
  if (option.repeats) add("...");
  if (!option.initial.empty()) add("[" + option.initial + "]");
  if (option.is_required) add("(required)");
  return text;
}

std::string shown_help(const Option& option) {
  std::string text = option.help;
  const char* separator = " One of ";
  for (const std::string& choice : option.choices) {
    text += separator + choice;
    separator = ", ";
  }
  if (!option.choices.empty()) text += '.';
  separator = " Not together with ";
  for (const std::string& other : option.excluded) {
    text += separator + other;
    separator = ", ";
  }
  if (!option.excluded.empty()) text += '.';
  for (const std::string& other : option.needed) text += " Only with " + other + '.';
  return wrapped(text, width);
}

std::string shown_end(const Verb& verb) {
  std::string text;
  if (!verb.notes().empty()) text += wrapped(verb.notes(), column + width) + '\n';
  text += "Example:";
  for (const std::string& example : verb.examples()) text += "\n  " + example;
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

// The library's image of the verbs, and what it read.
class Image {
 public:
  explicit Image(Verb& program) : app_(program.description(), program.name()) {
    app_.get_formatter()->column_width(column);
    app_.get_formatter()->label("Positionals", "Arguments");
    app_.get_formatter()->label("SUBCOMMAND", "VERB");
    add(app_, program);
    app_.set_version_flag("--version", producer(), "Show the version.");
  }

  CLI::App& app() { return app_; }

  // The verb that the command line named, as far as it went, and all words up to it.
  std::pair<Verb*, std::string> named() {
    CLI::App* last = &app_;
    std::string words = app_.get_name();
    while (!last->get_subcommands().empty()) {
      last = last->get_subcommands().front();
      words += ' ' + last->get_name();
    }
    return {verbs_.at(last), words};
  }

  // Gives each option of the verb its values.
  void hand_on(Verb& verb) {
    for (Option& option : verb.options()) {
      option.given = read_.at(&option)->count() > 0;
    }
    for (const Option& option : verb.options()) require_unless(verb, option);
    for (Option& option : verb.options()) {
      if (!option.given) continue;
      const std::vector<std::string>& values = read_.at(&option)->results();
      require_choice(option, values);
      option.take(values);
    }
  }

 private:
  static void require_unless(const Verb& verb, const Option& option) {
    if (option.unless.empty() || option.given) return;
    for (const std::string& other : option.unless) {
      if (verb.given(other)) return;
    }
    throw UsageError(option.name() + " is required (see voroproof " + verb.name() + " --help)");
  }

  static void require_choice(const Option& option, const std::vector<std::string>& values) {
    if (option.choices.empty()) return;
    const std::string& value = values[0];
    if (std::find(option.choices.begin(), option.choices.end(), value) != option.choices.end()) {
      return;
    }
    std::string all;
    for (const std::string& choice : option.choices) all += (all.empty() ? "" : ", ") + choice;
    throw UsageError(option.name() + ": " + value + " not in " + all +
                     suggestion(value, option.choices));
  }

  void add(CLI::App& app, Verb& verb) {
    verbs_[&app] = &verb;
    app.set_help_flag("-h,--help", "Show this help.");
    app.footer(shown_end(verb));
    for (Option& option : verb.options()) add(app, option);
    for (const Option& option : verb.options()) relate(app, option);
    for (Verb& below : verb.verbs()) {
      CLI::App& added = *app.add_subcommand(below.name(), wrapped(below.description(), width));
      added.group("Verbs");
      add(added, below);
    }
    if (!verb.verbs().empty()) app.require_subcommand(1);
  }

  void add(CLI::App& app, Option& option) {
    CLI::Option* read = read_[&option] = add(app, option, joined(option.names));
    read->required(option.is_required && option.unless.empty());
  }

  static CLI::Option* add(CLI::App& app, const Option& option, const std::string& names) {
    if (option.is_flag()) {
      CLI::Option* flag = app.add_flag_function(
          names, [](auto) {}, shown_help(option));
      // CLI11 would tell what excludes it, in the order of addresses; the help text does.
      flag->option_text(" ");
      return flag;
    }
    const auto accept = [](const CLI::results_t&) { return true; };
    CLI::Option* added = app.add_option(names, accept, shown_help(option));
    added->option_text(shown_type(option));
    if (option.repeats) {
      added->expected(1, CLI::detail::expected_max_vector_size)->take_all();
      added->allow_extra_args(option.is_argument() || option.takes_rest);
    } else {
      added->expected(option.values)->allow_extra_args(false);
    }
    return added;
  }

  static void relate(CLI::App& app, const Option& option) {
    for (const std::string& other : option.excluded) {
      app.get_option(option.name())->excludes(app.get_option(other));
    }
    for (const std::string& other : option.needed) {
      app.get_option(option.name())->needs(app.get_option(other));
    }
  }

  CLI::App app_;
  std::map<const CLI::App*, Verb*> verbs_;
  std::map<const Option*, CLI::Option*> read_;
};

std::vector<std::string> verb_names(const Verb& verb) {
  std::vector<std::string> names;
  for (const Verb& below : verb.verbs()) names.push_back(below.name());
  return names;
}

std::vector<std::string> option_names(const Verb& verb) {
  std::vector<std::string> names{"--help"};
  for (const Option& option : verb.options()) {
    if (!option.is_argument()) names.push_back(option.name());
  }
  return names;
}

// The message about a word that a verb does not know.
std::string unknown(const Verb& verb, const std::string& word) {
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    return "unknown option " + name + suggestion(name, option_names(verb));
  }
  if (!verb.verbs().empty()) return "unknown verb " + word + suggestion(word, verb_names(verb));
  return "argument " + word + " not expected";
}

std::string complaint(Image& image, const CLI::ParseError& error) {
  const auto& [verb, words] = image.named();
  const std::vector<std::string> rest = image.app().remaining(true);
  const std::string message = !rest.empty()            ? unknown(*verb, rest.front())
                              : !verb->verbs().empty() ? "no verb given"
                                                       : error.what();
  return message + " (see " + words + " --help)";
}

}  // namespace

const Verb* parse(Verb& program, int argc, const char* const* argv) {
  Image image(program);
  try {
    image.app().parse(argc, argv);
  } catch (const CLI::Success& asked) {
    image.app().exit(asked, std::cout, std::cerr);
    return nullptr;
  } catch (const CLI::ParseError& error) {
    throw UsageError(complaint(image, error));
  }
  Verb* const verb = image.named().first;
  image.hand_on(*verb);
  return verb;
}

std::string help_text(Verb& program, const std::vector<std::string>& words) {
  Image image(program);
  const Verb* verb = &program;
  const CLI::App* app = &image.app();
  std::string name = program.name();
  for (const std::string& word : words) {
    const std::vector<std::string> names = verb_names(*verb);
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end())
      throw UsageError(name + " has no verb " + word + suggestion(word, names));
    verb = &verb->verbs()[static_cast<std::size_t>(found - names.begin())];
    app = app->get_subcommand(word);
    name += ' ' + word;
  }
  return app->help(app == &image.app() ? "" : name.substr(0, name.rfind(' ')));
}

}  // namespace voroproof::internal
