// voroproof truth: the files of the truth set.
#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "apps/cli/interruption.h"
#include "apps/verbs/verbs.h"
#include "corpus/truth/lines.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string name;
  std::uint64_t first = 0, lines = 10'000;
  unsigned threads = 1;
  std::string output;
};

// Lines first, first + 1, ..., by so many threads.
std::vector<std::string> make_lines(const truth::File& file, std::uint64_t first,
                                    std::uint64_t count, unsigned threads) {
  std::vector<std::string> lines(count);
  std::atomic<std::uint64_t> next = 0;
  std::exception_ptr fault;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::uint64_t k = next++; k < count; k = next++) lines[k] = file.line(first + k);
    } catch (...) {
      const std::lock_guard lock(guard);
      fault = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned k = 1; k < threads; ++k) others.emplace_back(work);
    work();
  }
  if (fault) std::rethrow_exception(fault);
  return lines;
}

ExitCode write_truth(const Request& request) {
  const CooperativeInterruption interruption;
  const std::vector<truth::File>& files = truth::files();
  const auto file = std::find_if(files.begin(), files.end(),
                                 [&](const truth::File& f) { return f.name == request.name; });
  OutputFile out(request.output);
  out.write(heading(*file) + '\n');
  constexpr std::uint64_t block = 256;
  for (std::uint64_t k = 0; k < request.lines; k += block) {
    const std::uint64_t count = std::min(block, request.lines - k);
    for (const std::string& line : make_lines(*file, request.first + k, count, request.threads)) {
      out.write(line + '\n');
    }
    interruption.check();
  }
  out.commit();
  return ExitCode::ok;
}

}  // namespace

void add_truth(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "truth", "Write questions about disks with proved answers (corpus/truth/README.md)");
  std::vector<std::string> names;
  for (const truth::File& file : truth::files()) names.push_back(file.name);
  verb.choice("name", names, request->name, "The file of the truth set.").is_required = true;
  verb.whole("--first", request->first, 0, 1'000'000'000, "The number of the first line, from 0.");
  verb.whole("--lines", request->lines, 0, 1'000'000'000, "How many lines.");
  verb.whole("--threads", request->threads, 1, 1024, "The number of threads.");
  verb.output(request->output, "The file to write.").required();
  verb.example("voroproof truth incircle --lines 2000000 -o incircle.txt.gz");
  verb.does([request] { return write_truth(*request); });
}

}  // namespace voroproof::internal
