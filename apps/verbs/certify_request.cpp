#include "apps/verbs/certify_request.h"

#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/cli/limits.h"
#include "library/certification.h"

namespace voroproof::internal {

void read_tolerances(const CertifyRequest& request, const Rational& horizon,
                     CertifyOptions& options) {
  options.tolerance = time_argument("--tolerance", request.tolerance);
  options.law_tolerance = time_argument("--law-tolerance", request.law_tolerance);
  try {
    require_meaningful(options, horizon);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--") + fault.what());
  }
}

Verb& add_certify_options(Verb& program, const std::shared_ptr<CertifyRequest>& request) {
  Verb& verb = program.add_verb("certify", "Prove or refute a history of a scene");
  verb.input("scene", request->scene, "The scene.")
      .required_unless("--merge")
      .required_unless("--diagram");
  verb.input("history", request->history, "The history, whoever wrote it.")
      .required_unless("--merge")
      .required_unless("--diagram");
  verb.choice(
      "--truth", {"exact", "recorded"}, request->truth,
      "Which motion the history must describe: the true motion of the scene, or the one that "
      "the history's own collision times and velocities define (for long floating-point "
      "runs).");
  verb.choice("--events", {"all", "collisions"}, request->events,
              "What to judge: all events, or collisions and maneuvers alone, of a program that "
              "knows no flips. Flips and the initial diagram are passed over then.");
  verb.choice("--order", {"format", "any"}, request->order,
              "Exact truth: the order of what one instant turns, as docs/formats.md has it, or any "
              "in which every collision is of two that touch and approach (not with --strict).");
  verb.text("--tolerance", request->tolerance, "TIME",
            "How far a claimed time may be from the exact one; at most the horizon, or 1e-6 where "
            "the horizon is less.");
  verb.text("--law-tolerance", request->law_tolerance, "RATIO",
            "How far claimed velocities may be off, relative to the speeds that meet; at most 1.");
  verb.flag("--least-tolerances", request->least_tolerances,
            "Judge the history anew under other tolerances, and say the least powers of ten that "
            "certify it: whether events are wrong, or numbers only.")
      .excludes({"--merge", "--part", "--resume"});
  verb.flag("--strict", request->options.strict,
            "Refute claims that are out of order, however near they are, quadruplets without "
            "orientation, and a horizon other than the scene's.");
  verb.flag("--unoriented", request->options.unoriented,
            "Accept quadruplets whose third generators are exchanged, as in .evtsq files.");
  verb.flag(
      "--kernel", request->kernel,
      "Have the kernel (docs/kernel.md) judge the files, too: both must certify the history.");
  verb.flag("--proved", request->proved,
            "Have the proved checker (the program voroproof-proved, docs/proved.md) judge the "
            "files, too, under the recorded truth: both must certify the history.");
  verb.whole("--threads", request->options.threads, 1, 1024,
             "The number of threads where all events are judged, and for the initial diagram. The "
             "certificate is the same.");
  verb.output("--report", request->report, "Write everything that was found here, as JSON.");
  verb.text("--part", request->part, "I/N",
            "Certify the I-th of N shards of a history, under the recorded truth, and write its "
            "certificate as the report.")
      .needs("--report");
  verb.input(
          "--index", request->index,
          "An index of the history (voroproof index): a shard, or what --resume takes up, is read "
          "from the last place before it that the index names. Nothing in it is believed: --merge "
          "refuses shards that do not fit together.")
      .excludes({"--max-events"});
  verb.inputs("--merge", request->shards,
              "Join the certificates of all shards of a history to the verdict and the report of "
              "the whole.")
      .with_all_that_follow()
      .excludes({"--truth", "--events", "--order", "--tolerance", "--law-tolerance", "--strict",
                 "--unoriented", "--kernel", "--proved", "--threads", "--part", "--index",
                 "--resume", "--checkpoint", "--max-bits", "--max-events"});
  add_diagram_options(verb, request->diagram);
  verb.flag("--resume", request->resume,
            "Take up what a run that was interrupted or killed, or that a limit ended, has left "
            "beside this report; the report is the same as without the break. With --part, nothing "
            "is done where the report is that of this shard already: of these bytes, these options "
            "and this version.")
      .needs("--report");
  verb.whole("--checkpoint", request->checkpoint, 0, 1'000'000,
             "Under the recorded truth, keep what is proved every so many seconds in a file of the "
             "report's name with .partial at its end; 0: as often as can be.");
  add_max_bits(verb, request->options.motion.max_bits);
  add_max_events(verb, request->max_events);
  verb.flag("--quiet", request->quiet,
            "Show no progress on the terminal, and write nothing but the verdict, what it is about "
            "and what it leaves open.");
  verb.note(
      "What s CERTIFIED says is stated in docs/claim.md. The last line of the output is s "
      "CERTIFIED (exit code 0), s REFUTED (1), s INVALID (2) or s UNDECIDED (3).");
  verb.example("voroproof certify a.scene.json a.history.jsonl --truth recorded --report r.json");
  return verb;
}

}  // namespace voroproof::internal
