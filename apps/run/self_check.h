// The certifier at work beside the engine: it checks each event as it comes.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "certify/certifier.h"
#include "history/history_file.h"
#include "history/scene.h"

namespace voroproof::internal {

// The engine's thread hands on its events in batches and waits where the certifier falls too far
// behind. The certifier has a motion and a diagram of its own: nothing of the engine but the events
// and the initial diagram reaches it.
class SelfCheck {
 public:
  // `scene` must outlive the check; its horizon is that of the run.
  SelfCheck(const Scene& scene, const CertifyOptions& options);
  SelfCheck(const SelfCheck&) = delete;
  SelfCheck& operator=(const SelfCheck&) = delete;
  // Without finish(), what is still to be checked is dropped.
  ~SelfCheck();

  // `header` with the initial diagram.
  void begin(const HistoryHeader& header);
  void event(const Event& event);

  // Whether a verdict has been reached before the end, which can only be a bad one.
  bool over();

  // Waits for the verdict. Throws what the certifier threw.
  Certificate finish(const std::variant<HistoryEnd, HistoryStop>& ending);

 private:
  class Live;
  using Batch = std::vector<Event>;
  static constexpr std::size_t batch_size = 256;
  static constexpr std::size_t max_batches = 64;

  const Scene& scene_;
  CertifyOptions options_;
  Batch batch_;  // used by the engine's thread
  std::unique_ptr<Live> live_;
  std::optional<Certificate> certificate_;
  std::exception_ptr error_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace voroproof::internal
