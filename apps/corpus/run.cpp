#include "apps/corpus/run.h"

#include <algorithm>
#include <fstream>

#include "apps/corpus/scratch_folder.h"
#include "exact/patience.h"
#include "history/error.h"
#include "library/snapshot.h"

namespace voroproof::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_message = 300;
constexpr std::size_t longest_tail = std::size_t{1} << 14;  // bytes of stderr that are looked at

std::string last_line(const std::string& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) return {};
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - static_cast<std::streamoff>(longest_tail)));
  std::string line, last;
  while (std::getline(in, line)) {
    if (!line.empty()) last = line;
  }
  return printable(last, longest_message);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

// The rank of a verdict, the least for the best. The better of a history's two judgements decides:
// whoever holds against one truth is right.
int rank(CaseJudgement::Verdict verdict) {
  switch (verdict) {
    case CaseJudgement::Verdict::certified:
      return 0;
    case CaseJudgement::Verdict::undecided:
      return 1;
    case CaseJudgement::Verdict::refuted:
      return 2;
    case CaseJudgement::Verdict::invalid:
      break;
  }
  return 3;
}

CaseOutcome outcome_of(CaseJudgement::Verdict verdict) {
  switch (verdict) {
    case CaseJudgement::Verdict::certified:
      return CaseOutcome::certified;
    case CaseJudgement::Verdict::refuted:
      return CaseOutcome::refuted;
    case CaseJudgement::Verdict::undecided:
      return CaseOutcome::undecided;
    case CaseJudgement::Verdict::invalid:
      break;
  }
  return CaseOutcome::invalid;
}

// Draws the outcome from the judgements and from the program's own end.
void conclude(ProgramResult& result) {
  const CaseJudgement* decisive = result.decisive();
  if (result.end.kind == ProcessEnd::Kind::timed_out) {
    result.outcome = CaseOutcome::timed_out;
    result.reason = "no end within the time limit";
  } else if (!result.end.success() &&
             (!decisive || decisive->verdict != CaseJudgement::Verdict::undecided)) {
    result.outcome = CaseOutcome::crashed;
    result.reason = description(result.end);
    if (!result.message.empty()) result.reason += ": " + result.message;
  } else if (!decisive) {
    result.outcome = CaseOutcome::invalid;
    result.reason = "no history was written";
  } else {
    result.outcome = outcome_of(decisive->verdict);
    result.reason = decisive->reason;
  }
}

void run_all(std::vector<std::shared_ptr<ProcessJob>> jobs, const CorpusRunOptions& options) {
  if (!run_jobs(std::move(jobs), options.jobs, options.progress)) throw Interrupted();
}

// Judges a history that the program wrote, against each truth.
void add_judging(ProcessJob& job, ProgramResult& result, const fs::path& folder,
                 const std::string& history, const CorpusRunOptions& options) {
  const std::string report = (folder / "report").string();
  for (const Truth truth : options.truths) {
    std::optional<CaseJudgement>& into = truth == Truth::exact ? result.exact : result.recorded;
    job.push_back(judging(result.of->scene(), history, truth, options.events, report,
                          options.limits,
                          [&into](const CaseJudgement& judgement) { into = judgement; }));
  }
  if (!result.of->decided) {
    job.push_back(judging(result.of->scene(), result.of->history(), Truth::exact, options.events,
                          report, options.limits,
                          [&result](const CaseJudgement& j) { result.own = j; }));
  }
  job.back().on_end = [&result, folder, judged = job.back().on_end](const ProcessEnd& end) {
    judged(end);
    conclude(result);
    fs::remove_all(folder);
  };
}

std::string judged_text(const CaseJudgement& j, std::string_view truth) {
  std::string text = std::string(name_of(j.verdict)) + " (" + std::string(truth) + ")";
  if (j.verdict == CaseJudgement::Verdict::refuted) text += ": " + j.kind;
  return text;
}

// Compares an expected diagram with that of the exact history at the same instant.
ProcessStep comparing(const CorpusCase& c, std::size_t k, const ProcessLimits& limits,
                      OwnCheck& check) {
  constexpr int equal = 0, other_instant = 10, other_edges = 11, no_diagram = 12;
  const auto compare = [&c, k] {
    try {
      const DiagramFile expected = read_diagram(c.diagram(k));
      if (expected.t != round_nearest(c.instants[k])) return other_instant;
      // A history does not tell what lies between two of its events of one binary64; then the
      // motion does.
      const Rational& t = c.instants[k];
      const DiagramFile found = to_rational(round_nearest(t)) == t
                                    ? snapshot(read_scene(c.scene()), c.history(), t)
                                    : snapshot(read_scene(c.scene()), t);
      return expected.edges == found.edges && expected.scene_sha256 == found.scene_sha256
                 ? equal
                 : other_edges;
    } catch (const std::exception&) {
      return no_diagram;
    }
  };
  return {.work = compare, .limits = limits, .on_end = [&check](const ProcessEnd& end) {
            check.seconds = end.seconds;
            if (end.success()) {
              check.found = check.expected;
              return;
            }
            check.found = end.kind != ProcessEnd::Kind::exited ? description(end)
                          : end.code == other_edges            ? "other edges"
                          : end.code == other_instant          ? "another instant"
                          : end.code == no_diagram             ? "no diagram"
                                                               : description(end);
          }};
}

}  // namespace

const CaseJudgement* ProgramResult::decisive() const {
  const CaseJudgement* best = nullptr;
  for (const std::optional<CaseJudgement>* j : {&recorded, &exact}) {
    if (*j && (!best || rank((*j)->verdict) < rank(best->verdict))) best = &**j;
  }
  return best;
}

bool ProgramResult::passed() const {
  if (outcome == CaseOutcome::certified) return true;
  const auto reaches = [this](const std::optional<CaseJudgement>& j) {
    return j && own && j->prefix_t >= own->prefix_t - CertifyOptions().tolerance.get_d();
  };
  return outcome == CaseOutcome::undecided && (reaches(exact) || reaches(recorded));
}

bool OwnResult::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const OwnCheck& c) { return c.passed(); });
}

std::vector<ProgramResult> against_program(const std::vector<CorpusCase>& cases,
                                           const CorpusRunOptions& options) {
  const ScratchFolder scratch;
  std::vector<ProgramResult> results(cases.size());
  std::vector<std::shared_ptr<ProcessJob>> jobs;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    ProgramResult& result = results[k];
    result.of = &cases[k];
    const fs::path folder = scratch.folder(k);
    const std::string scene = (folder / "scene.scene.json").string();
    const std::string history = (folder / "out.history.jsonl").string();
    const std::string out = (folder / "stdout").string(), err = (folder / "stderr").string();
    fs::copy_file(result.of->scene(), scene);
    const std::string command = replaced(replaced(options.command, "{scene}", shell_word(scene)),
                                         "{history}", shell_word(history));
    auto job = std::make_shared<ProcessJob>();
    const auto on_end = [&result, &options, folder, history, err,
                         job = job.get()](const ProcessEnd& end) {
      result.end = end;
      result.message = last_line(err);
      const bool judged = end.kind == ProcessEnd::Kind::exited && fs::is_regular_file(history);
      if (judged) {
        add_judging(*job, result, folder, history, options);
      } else {
        conclude(result);
        fs::remove_all(folder);
      }
    };
    job->push_back({.work = [command, out, err] { return become_shell(command, out, err); },
                    .limits = options.limits,
                    .on_end = on_end,
                    .foreign = true});
    jobs.push_back(std::move(job));
  }
  run_all(std::move(jobs), options);
  return results;
}

std::vector<OwnResult> own_histories(const std::vector<CorpusCase>& cases,
                                     const CorpusRunOptions& options) {
  const ScratchFolder scratch;
  std::vector<OwnResult> results(cases.size());
  std::vector<std::shared_ptr<ProcessJob>> jobs;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const CorpusCase& c = cases[k];
    OwnResult& result = results[k];
    result.of = &c;
    result.checks.reserve(1 + c.instants.size() + c.wrong.size());  // steps refer to them
    const std::string report = (scratch.folder(k) / "report").string();
    auto job = std::make_shared<ProcessJob>();
    const auto judge = [&](const std::string& file, const std::string& truth,
                           const std::string& expected) {
      result.checks.push_back({.file = file, .expected = expected, .found = {}, .reason = {}});
      OwnCheck& check = result.checks.back();
      job->push_back(judging(c.scene(), c.path(file),
                             truth == "exact" ? Truth::exact : Truth::recorded, EventKinds::all,
                             report, options.limits, [&check, truth](const CaseJudgement& j) {
                               check.found = judged_text(j, truth);
                               check.reason = j.reason;
                               check.seconds = j.seconds;
                             }));
    };
    judge("exact.history.jsonl", "exact", c.decided ? "certified (exact)" : "undecided (exact)");
    for (std::size_t i = 0; i < c.instants.size(); ++i) {
      result.checks.push_back({.file = fs::path(c.diagram(i)).filename().string(),
                               .expected = "same edges",
                               .found = {},
                               .reason = {}});
      job->push_back(comparing(c, i, options.limits, result.checks.back()));
    }
    for (const WrongHistory& w : c.wrong) {
      judge(w.file, w.truth, "refuted (" + w.truth + "): " + w.kind);
    }
    jobs.push_back(std::move(job));
  }
  run_all(std::move(jobs), options);
  return results;
}

}  // namespace voroproof::internal
