// voroproof corpus: the degenerate cases, and other engines held against them.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/corpus/case.h"
#include "apps/corpus/html.h"
#include "apps/corpus/report.h"
#include "apps/corpus/run.h"
#include "apps/corpus/text.h"
#include "apps/verbs/program_run.h"
#include "apps/verbs/verbs.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string root;  // empty: the corpus beside the program
  CaseSelection selection;
  std::string numbers = "all";
  // The options of `corpus run`.
  ProgramRun program;
  std::string json, html;
};

std::vector<CorpusCase> cases_of(const Request& request) {
  const std::string root = request.root.empty() ? corpus_beside_program() : request.root;
  if (root.empty()) {
    throw UsageError("no corpus beside this program: name the folder of its cases (--corpus)");
  }
  try {
    CaseSelection selection = request.selection;
    selection.doubles = request.numbers == "doubles";
    return find_cases(root, selection);
  } catch (const CorpusError& error) {
    throw UsageError(error.what());
  }
}

ExitCode list_cases(const Request& request) {
  std::cout << list_text(cases_of(request));
  return ExitCode::ok;
}

ExitCode show_case(const Request& request) {
  const std::vector<CorpusCase> cases = cases_of(request);
  if (cases.size() > 1) {
    throw UsageError(request.selection.names.front() + ": more than one case has this name; give " +
                     cases[0].id() + " or " + cases[1].id());
  }
  std::cout << case_text(cases.front());
  return ExitCode::ok;
}

// "12 of 150 cases" on one line of a terminal.
class CaseCounter {
 public:
  explicit CaseCounter(std::size_t all) : all_(all), shown_(isatty(STDERR_FILENO) == 1) {}
  CaseCounter(const CaseCounter&) = delete;
  CaseCounter& operator=(const CaseCounter&) = delete;
  ~CaseCounter() {
    if (last_) std::fputs("\r\033[K", stderr);
  }

  void report(std::size_t finished) {
    if (!shown_ || last_ == finished) return;
    std::fprintf(stderr, "\r%zu of %zu cases\033[K", finished, all_);
    last_ = finished;
  }

 private:
  std::size_t all_;
  bool shown_;
  std::optional<std::size_t> last_;
};

// Writes the reports asked for and returns whether all cases passed.
template <class Result>
bool report(std::ostream& out, const CorpusRunInfo& info, const std::vector<Result>& results,
            std::optional<OutputFile>& json, std::optional<OutputFile>& html) {
  out << report_for_terminal(info, results);
  if (json) {
    json->write(report_json(info, results));
    json->commit();
  }
  if (html) {
    html->write(report_html(info, results));
    html->commit();
  }
  return std::all_of(results.begin(), results.end(),
                     [](const Result& result) { return result.passed(); });
}

ExitCode run_cases(const Request& request) {
  const bool against = !request.program.command.empty();
  request.program.require_valid();
  require_distinct({}, {request.json, request.html});
  std::optional<OutputFile> json, html;
  if (!request.json.empty()) json.emplace(request.json);
  if (!request.html.empty()) html.emplace(request.html);
  const std::vector<CorpusCase> cases = cases_of(request);
  const CooperativeInterruption interruption;
  std::optional<CaseCounter> counter;
  counter.emplace(cases.size());
  const CorpusRunOptions options = request.program.options([&](std::size_t finished) {
    counter->report(finished);
    interruption.check();
    return true;
  });
  const CorpusRunInfo info{.producer = producer(),
                           .command = options.command,
                           .truths = options.truths,
                           .events = options.events,
                           .limits = options.limits};
  std::ostream& out = words_beside({request.json, request.html});
  bool all_passed = false;
  if (against) {
    const std::vector<ProgramResult> results = against_program(cases, options);
    counter.reset();
    all_passed = report(out, info, results, json, html);
  } else {
    const std::vector<OwnResult> results = own_histories(cases, options);
    counter.reset();
    all_passed = report(out, info, results, json, html);
  }
  return all_passed ? ExitCode::ok : ExitCode::refuted;
}

void add_corpus_folder(Verb& verb, Request& request) {
  verb.text("--corpus", request.root, "DIR",
            "The folder of the cases; those that came with the program where it is not given.");
}

void add_selection(Verb& verb, Request& request) {
  verb.list("--family", request.selection.families, "NAME", "Only cases of this family.");
  verb.list("--tag", request.selection.tags, "NAME", "Only cases with this tag.");
  verb.choice("--numbers", {"all", "doubles"}, request.numbers,
              "All scenes, or those whose numbers are all JSON numbers, for engines that read no "
              "exact text such as \"1/3\".");
}

void add_list(Verb& corpus) {
  auto request = std::make_shared<Request>();
  Verb& verb = corpus.add_verb("list", "A table of the cases");
  add_selection(verb, *request);
  add_corpus_folder(verb, *request);
  verb.example("voroproof corpus list --family lattices");
  verb.does([request] { return list_cases(*request); });
}

void add_show(Verb& corpus) {
  auto request = std::make_shared<Request>();
  Verb& verb = corpus.add_verb("show", "One case: its story, its scene, its events, its files");
  std::string& name = request->selection.names.emplace_back();
  verb.text("name", name, "NAME", "The case, as NAME or FAMILY/NAME.").required();
  add_corpus_folder(verb, *request);
  verb.example("voroproof corpus show cradles/cradle-02");
  verb.does([request] { return show_case(*request); });
}

void add_run(Verb& corpus) {
  auto request = std::make_shared<Request>();
  Verb& verb = corpus.add_verb(
      "run",
      "Certify the corpus: its own histories and wrong ones or, with --against, the histories that "
      "another program writes for its scenes");
  request->program.add_to(verb, false);
  add_selection(verb, *request);
  verb.list("--case", request->selection.names, "NAME", "Only this case, NAME or FAMILY/NAME.");
  verb.output("--json", request->json, "Write everything that was found here.");
  verb.output("--html", request->html, "Write a page to look at here, pictures included.");
  add_corpus_folder(verb, *request);
  verb.note("Exit code 0 if every case is as expected or certified, 1 if not, 2 for bad usage.");
  verb.example("voroproof corpus run --against 'mysim --in {scene} --out {history}' --html r.html");
  verb.does([request] { return run_cases(*request); });
}

}  // namespace

void add_corpus(Verb& program) {
  Verb& corpus =
      program.add_verb("corpus", "The degenerate cases: look at them, run any program on them");
  add_list(corpus);
  add_show(corpus);
  add_run(corpus);
  corpus.example("voroproof corpus run --against 'mysim {scene} {history}'");
}

}  // namespace voroproof::internal
