#include "voroproof/movie.h"
#include "voroproof/version.h"

#include <stdexcept>

#include "history/claim.h"
#include "library/explanation.h"
#include "library/movie/movie.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

std::string movie_of(Claim&& claim, const voroproof::MovieOptions& options) {
  const std::string producer = "voroproof " VOROPROOF_VERSION;
  std::optional<Explanation> report;
  if (options.report != nullptr) {
    report = explain_report_text(options.report->json, "report");
    require_report_of(*report, "report", producer, claim.scene.sha256,
                      claim.history->content_sha256());
  }
  const std::int64_t line = report && report->fault ? report->fault->line : 0;
  MovieSpan span;
  span.flips = !report || report->judges_flips;
  const MovieData data = movie_data(claim, "history", span, line);
  std::string page;
  make_movie(claim, data, report ? &*report : nullptr,
             {.producer = producer, .follow = options.follow},
             [&](std::string_view piece) { page += piece; });
  return page;
}

}  // namespace
}  // namespace internal

std::string movie_page(const Scene& scene, const History& history, const MovieOptions& options) {
  return internal::with_public_errors([&] {
    internal::Claim claim = internal::memory_claim(scene, history);
    const auto disks = static_cast<int>(claim.scene.disks.size());
    if (options.follow && (*options.follow < 0 || *options.follow >= disks)) {
      throw std::invalid_argument("follow: there is no disk " + std::to_string(*options.follow));
    }
    return internal::movie_of(std::move(claim), options);
  });
}

}  // namespace voroproof
