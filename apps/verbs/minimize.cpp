// voroproof minimize: the smallest scene on which a program still makes a mistake.
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "apps/cli/interruption.h"
#include "apps/corpus/minimize.h"
#include "apps/verbs/program_run.h"
#include "apps/verbs/verbs.h"
#include "history/output_file.h"
#include "history/scene_writer.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, output;
  ProgramRun program;
};

void write_scene_file(const std::string& path, const Scene& scene) {
  std::ostringstream text;
  write_scene(text, scene);
  write_output(path, text.view());
}

std::string size_of(const Scene& scene) {
  std::ostringstream text;
  text << scene.disks.size() << " disks, " << scene.maneuvers.size() << " maneuvers, horizon "
       << scene.horizon.get_d();
  return text.str();
}

ExitCode minimize(const Request& request) {
  require_distinct({request.scene}, {request.output});
  request.program.require_valid();
  const Scene scene = read_scene(request.scene);
  CooperativeInterruption interruption;
  const CorpusRunOptions options = request.program.options([&](std::size_t) {
    interruption.check();
    return true;
  });
  Minimization work(scene, options);
  if (!work.mistake().is_one()) {
    throw UsageError(request.scene + ": the program's history of this scene is certified");
  }
  // However it ends, what it came to is kept.
  std::exception_ptr end;
  try {
    work.run();
  } catch (...) {
    end = std::current_exception();
    interruption.wind_up();
  }
  write_scene_file(request.output, work.scene());
  words_beside({request.output}) << "from " << size_of(scene) << "\nto   " << size_of(work.scene())
                                 << ", in " << work.runs() << " runs: "
                                 << outcome_names[static_cast<std::size_t>(work.mistake().outcome)]
                                 << ": " << work.mistake().reason << '\n';
  if (end) std::rethrow_exception(end);
  return ExitCode::ok;
}

}  // namespace

void add_minimize(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "minimize", "Write the smallest scene on which another program makes the same mistake");
  verb.input("scene", request->scene, "A scene on which it makes one.").required();
  request->program.add_to(verb, true);
  verb.output(request->output, "The scene to write.").required();
  verb.note(
      "The mistake is the same where the history is refuted for the same kind of fault, or the "
      "program crashes, ends too late or writes no valid history, as it did at first. Exit code 2 "
      "if it makes none.");
  verb.example(
      "voroproof minimize a.scene.json --against 'mysim {scene} {history}' -o b.scene.json");
  verb.does([request] { return minimize(*request); });
}

}  // namespace voroproof::internal
