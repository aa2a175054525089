// The readers. An InputError is a refusal; whatever else comes out of one is a find, and so is a
// file that is read, written, and read again as another.
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "apps/corpus/case.h"
#include "apps/draw/plan_drawing.h"
#include "apps/draw/plan_picture.h"
#include "apps/draw/render.h"
#include "certify/kernel/files.h"
#include "history/byte_source.h"
#include "history/diagram_file.h"
#include "history/disk_file.h"
#include "history/error.h"
#include "history/evtsq_reader.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "history/paths_file.h"
#include "history/paths_scene.h"
#include "history/paths_world.h"
#include "history/plan_file.h"
#include "history/scene.h"
#include "history/scene_writer.h"
#include "history/validate.h"
#include "library/explanation.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/target.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::fuzz {
namespace {

constexpr int picture_size = 64;
constexpr int disks = 8;  // of the scene to which a sequence or a history belongs

template <class Read>
bool accepts(Read&& read) {
  try {
    read();
    return true;
  } catch (const InputError& refusal) {
    const std::string_view message = refusal.what();
    const bool one_line = std::none_of(message.begin(), message.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    });
    if (!one_line) throw std::logic_error("a message that is not one printable line");
    return false;
  }
}

std::string written(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

bool scene(std::string_view bytes) {
  return accepts([&] {
    const std::string text = written(parse_scene(bytes, "scene"));
    if (written(parse_scene(text, "copy")) != text) {
      throw std::logic_error("a scene is not the same when it is read again");
    }
  });
}

bool disk_file(std::string_view bytes) {
  return accepts([&] { read_disk_file(file_with(bytes)); });
}

bool history(std::string_view bytes) {
  return accepts([&] {
    HistoryReader reader(file_with(bytes), disks);
    while (reader.next()) {
    }
    reader.counts_match();
    is_complete_history(file_with(bytes));
  });
}

bool sequence(std::string_view bytes) {
  const std::string& path = file_with(bytes);
  const bool alone = accepts([&] { validate_file(path); });
  std::vector<std::int64_t> ids(disks);
  for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = static_cast<std::int64_t>(k);
  accepts([&] { read_evtsq_setting(path, ids); });
  return accepts([&] {
           const auto source = open_evtsq(path, ids, Rational(40)).history;
           while (source->next()) {
           }
         }) &&
         alone;
}

bool diagram(std::string_view bytes) {
  return accepts([&] { parse_diagram(bytes, "diagram"); });
}

// As the verb render does. Whoever may read the file may ask for it to be drawn.
bool picture(std::string_view bytes) {
  static const TemporaryDirectory folder;
  return accepts([&] {
    const DiagramFile file = parse_diagram(bytes, "diagram");
    try {
      render_diagram(file, folder.file("drawn.svg"), {.size = picture_size});
    } catch (const std::invalid_argument& fault) {
      throw InputError("diagram", 0, "", fault.what());
    }
  });
}

bool plan_report(std::string_view bytes) {
  static const TemporaryDirectory folder;
  return accepts([&] {
    draw_plan(read_plan_report(file_with(bytes)), folder.file("drawn.svg"), picture_size);
  });
}

bool plan(std::string_view bytes) {
  return accepts([&] { parse_plan(bytes, "plan"); });
}

bool table(std::string_view bytes) {
  return accepts([&] {
    const GivenPaths paths = read_path_table(file_with(bytes), Rational(1, 2));
    world_of_paths(paths, Rational(1, 8), "paths");
    scene_of_paths(paths, "paths");
  });
}

bool ccbs(std::string_view bytes) {
  return accepts([&] {
    const GivenPaths paths = parse_ccbs_log(std::string(bytes), "log", Rational(1, 2));
    scene_of_paths(paths, "paths");
  });
}

bool corpus_case(std::string_view bytes) {
  return accepts([&] { parse_case(bytes, "family/case/case.json"); });
}

bool report(std::string_view bytes) {
  return accepts([&] {
    const std::string words = explain_report_text(std::string(bytes), "report").words;
    const bool controls = std::any_of(words.begin(), words.end(), [](char c) {
      return c != '\n' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f);
    });
    if (controls) throw std::logic_error("words that control the terminal");
  });
}

bool compressed(std::string_view bytes) {
  constexpr std::size_t most = std::size_t{1} << 22;  // that is expanded: some may have no end
  return accepts([&] {
    ByteSource source(file_with(bytes));
    char buffer[1 << 12];
    for (std::size_t got = 1, all = 0; got > 0 && all < most; all += got) {
      got = source.read(buffer, sizeof buffer);
    }
  });
}

// Whatever it is.
bool any_file(std::string_view bytes) {
  const std::string& path = file_with(bytes);
  is_scene_file(path);
  is_history_file(path);
  return accepts([&] { validate_file(path); });
}

template <class Read>
bool kernel_accepts(Read&& read) {
  try {
    read();
    return true;
  } catch (const voroproof_kernel::Stop& stop) {
    if (stop.verdict != voroproof_kernel::Verdict::invalid) {
      throw std::logic_error("a reader of the kernel that judges");
    }
    return false;
  }
}

bool kernel_scene(std::string_view bytes) {
  return kernel_accepts([&] { voroproof_kernel::read_scene(std::string(bytes)); });
}

bool kernel_history(std::string_view bytes) {
  voroproof_kernel::Scene scene;
  scene.disks.resize(disks);
  return kernel_accepts([&] { voroproof_kernel::read_history(std::string(bytes), scene); });
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"scene", scene, 20'000},
      {"disks", disk_file, 20'000},
      {"history", history, 20'000},
      {"sequence", sequence, 10'000},
      {"diagram", diagram, 20'000},
      {"picture", picture, 500},
      {"plan", plan, 20'000},
      {"plan-report", plan_report, 500},
      {"waypoints", table, 20'000},
      {"ccbs", ccbs, 20'000},
      {"case", corpus_case, 20'000},
      {"report", report, 20'000},
      {"compressed", compressed, 10'000},
      {"any", any_file, 4'000},
      {"kernel-scene", kernel_scene, 20'000},
      {"kernel-history", kernel_history, 20'000},
      {"shard", reads_shard, 10'000},
      {"merge", merges, 4'000},
      {"index", reads_index, 1'000},
      {"begun-report", resumes_certificate, 1'000},
      {"begun-history", resumes_history, 1'000},
      {"certify", certifies, 2'000},
  };
  return all;
}

const Target& target(std::string_view name) {
  for (const Target& t : targets()) {
    if (t.name == name) return t;
  }
  throw std::invalid_argument("there is no target " + std::string(name));
}

}  // namespace voroproof::internal::fuzz
