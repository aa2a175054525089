#include "certify/part_reader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "certify/fingerprint.h"
#include "history/error.h"

namespace voroproof::internal {

namespace {

// The smallest parts are so many times smaller than most.
constexpr int kSmall = 8;

// The number of claims that are read before the one before them is taken.
constexpr std::size_t kAhead = 3;

}  // namespace

void ClaimList::add(Event&& event, std::int64_t line) {
  const auto* flip = std::get_if<FlipEvent>(&event);
  if (flip != nullptr && !flip->exact) {
    claims_.push_back({flip->t, flip->quad, line});
  } else {
    claims_.push_back({0, {kOther, static_cast<GenId>(others_.size()), 0, 0}, line});
    others_.push_back(std::move(event));
  }
}

std::optional<Event> ClaimList::event(std::size_t k) const {
  const Claim& claim = claims_[k];
  if (claim.quad.l == kOther) return others_[static_cast<std::size_t>(claim.quad.r)];
  std::optional<Event> event(std::in_place, std::in_place_type<FlipEvent>);
  auto& flip = std::get<FlipEvent>(*event);
  flip.t = claim.t;
  flip.quad = claim.quad;
  return event;
}

// Parts of a history as a history.
class PartReader::Section : public HistorySource {
 public:
  using Lists = std::vector<std::shared_ptr<const ClaimList>>;

  // `rest`: what follows these claims, where nothing else does. `turns`: others are passed over.
  Section(const HistoryHeader& header, Lists lists, ReadAhead* rest, bool turns = false)
      : header_(header), lists_(std::move(lists)), rest_(rest), turns_(turns) {}

  void set_next_line(std::int64_t line) { next_line_ = line; }

  const HistoryHeader& header() const override { return header_; }
  std::optional<Event> next() override {
    for (; list_ < lists_.size(); ++list_, taken_ = 0) {
      const ClaimList& claims = *lists_[list_];
      if (turns_) taken_ = claims.turn_from(taken_);
      if (taken_ == claims.size()) continue;
      claims.prefetch(taken_);
      line_ = claims.line(taken_);
      return claims.event(taken_++);
    }
    ReadAhead::Claim* const claim = rest_ != nullptr ? rest_->first() : nullptr;
    if (claim == nullptr) {
      line_ = rest_ != nullptr ? rest_->history().line() : next_line_;
      return std::nullopt;
    }
    line_ = claim->line;
    std::optional<Event> event = std::move(claim->given);
    rest_->drop_first();
    return event;
  }
  std::int64_t line() const override { return line_; }
  // A part that is not the last does not stop.
  const std::variant<HistoryEnd, HistoryStop>& ending() const override {
    static const std::variant<HistoryEnd, HistoryStop> goes_on;
    return rest_ != nullptr ? rest_->history().ending() : goes_on;
  }
  // Only the last part has counts.
  const HistoryCounts& counts() const override { return rest_->history().counts(); }
  bool counts_match() const override { return rest_->history().counts_match(); }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

 private:
  const HistoryHeader& header_;
  Lists lists_;
  std::size_t list_ = 0, taken_ = 0;  // the next claim, in which list
  ReadAhead* rest_;
  bool turns_;
  std::int64_t line_ = 1;
  std::int64_t next_line_ = 0;  // line of the first claim after the part
};

PartReader::PartReader(const Scene& scene, const MotionInput& input, HistorySource& history,
                       const CertifyOptions& options, std::vector<std::string>& remarks, bool marks)
    : input_(input),
      history_(history),
      options_(options),
      remarks_(remarks),
      header_(history.header()),
      gap_(8 * round_up(options.tolerance)),
      size_(std::max(options.least_part, options.least_part * scene.disks.size() / 512)),
      horizon_(header_.horizon.get_d()),
      replay_(scene, options),
      ahead_(history, kAhead),
      before_(replay_),
      marks_(marks) {
  if (!marks) return;
  offset_ = history.offset();
  history.keep_digest();
  history.settle(offset_);
  header_sha256_ = fingerprint_of(scene, header_);
}

void PartReader::start_at(const IndexedCut& start) {
  const Cut& cut = start.cut;
  replay_.read(start);
  std::optional<Sha256> digest = Sha256::resumed(start.digest, cut.offset);
  if (!digest) throw InputError(start.file, start.line, "cut.digest", "no state of SHA-256");
  if (!history_.skip_to({cut.offset, cut.line, cut.t, cut.claims, std::move(digest)})) {
    throw InputError(start.file, 0, "", "the history is none that can be read from the middle");
  }
  before_ = replay_;
  number_ = static_cast<std::size_t>(cut.part);
  begin_ = cut.t;
  in_parts_ = static_cast<std::size_t>(cut.claims.all());
  taken_ = cut.claims;
  line_ = cut.line;
  offset_ = cut.offset;
  history_.settle(offset_);
  // Behind a cut there is a claim.
  if (!ahead_.first()) throw InputError(start.file, start.line, "cut.offset", "no event follows");
}

Cut PartReader::cut() const {
  Fingerprint state;
  replay_.add_to(state);
  return {static_cast<std::int64_t>(number_),
          begins_at(),
          taken_,
          line_,
          offset_,
          header_sha256_,
          digest().hex(),
          state.hex()};
}

// Precondition: there is one.
void PartReader::take_next_claim() {
  if (const auto* later = ahead_.after(kAhead)) replay_.prefetch(later->event());
  ReadAhead::Claim& claim = *ahead_.first();
  const Replay::Place place = clear_ ? replay_.take(claim.event()) : Replay::Place{};
  clear_ = !place.is_none();
  places_.push_back(place);
  last_ = time(claim.event());
  line_ = claim.line;
  offset_ = claim.offset;
  if (marks_) history_.settle(offset_);
  taken_.add(claim.event());
  claims_.add(std::move(claim.event()), claim.line);
  ahead_.drop_first();
}

// Collisions and maneuvers at t = 0 come before the initial diagram.
void PartReader::begin_history() {
  for (;;) {
    const ReadAhead::Claim* next = ahead_.first();
    if (!next || !clear_ || time(next->event()) != 0 ||
        std::holds_alternative<FlipEvent>(next->event()))
      break;
    take_next_claim();
  }
  try {
    take_initial_diagram();
    before_.diagram() = replay_.diagram();
  } catch (const std::invalid_argument&) {
    clear_ = false;  // for the first part to say why
  } catch (const Undecided&) {
    clear_ = false;
  }
}

// Throws std::invalid_argument where the file's, or the one proposed, is none.
void PartReader::take_initial_diagram() {
  if (replay_.disks() < 2) return;
  if (!header_.initial && options_.propose_initial) {
    GivenMotion motion(input_, options_.motion);
    replay_.move(motion);  // collisions at t = 0
    header_.initial = options_.propose_initial(motion);
    remarks_.push_back(constructed_initial_remark);
  }
  replay_.diagram() = diagram_of(replay_.disks(), header_.initial.value_or(std::vector<Quad>()));
}

// Whether the present part has claims enough to end. The first part and the last ones are small: at
// the beginning other threads wait for it, at the end for each other. The claims read so far tell
// how many are to come: half of these are enough, between two bounds. Of a short history of many
// disks the first part is half as long as what follows.
bool PartReader::is_full() const {
  const std::size_t small = size_ / kSmall, most = number_ == 0 ? small : size_;
  const std::size_t least = number_ == 0 ? std::max(options_.least_part, small) / kSmall : small;
  if (claims_.size() < least) return false;
  if (claims_.size() >= most) return true;
  // size + 1 > 1/2 all (horizon / t - 1), without a division: this is asked of every claim.
  const auto size = static_cast<double>(claims_.size());
  return 2 * (size + 1) * last_ > (static_cast<double>(in_parts_) + size) * (horizon_ - last_);
}

// Whether the part may end before the next claim, which is there.
bool PartReader::may_end() const {
  return is_full() && time(ahead_.after(0)->event()) - last_ > gap_;
}

std::optional<Part> PartReader::next() {
  if (done_) return std::nullopt;
  if (number_ == 0) {
    begin_history();
  } else {
    claims_.reserve(size_);
    places_.reserve(size_);
    take_next_claim();
  }
  while (const ReadAhead::Claim* next = clear_ ? ahead_.first() : nullptr) {
    if (!may_end()) {
      take_next_claim();
      continue;
    }
    const double until = last_ + 0.5 * (time(next->event()) - last_);
    in_parts_ += claims_.size();
    const auto list = std::make_shared<const ClaimList>(std::exchange(claims_, {}));
    auto section = std::make_unique<Section>(header_, Section::Lists{list}, nullptr);
    section->set_next_line(next->line);
    return Part{number_++,
                list,
                std::move(section),
                std::exchange(places_, {}),
                std::exchange(before_, replay_),
                std::exchange(begin_, until),
                PartEnd{until, replay_.diagram()}};
  }
  return rest();
}

Part PartReader::rest() {
  done_ = true;
  // No cut follows, and what is left may be long.
  if (marks_) history_.settle(LineSource::all_given);
  const auto list = std::make_shared<const ClaimList>(std::move(claims_));
  return Part{number_++,
              list,
              std::make_unique<Section>(header_, Section::Lists{list}, &ahead_),
              std::move(places_),
              std::move(before_),
              begin_,
              std::nullopt};
}

std::unique_ptr<HistorySource> PartReader::rest(Section::Lists lists) {
  return std::make_unique<Section>(history_.header(), std::move(lists), &ahead_);
}

std::unique_ptr<HistorySource> PartReader::turns(const Part& part) const {
  return std::make_unique<Section>(header_, Section::Lists{part.list}, nullptr, true);
}

}  // namespace voroproof::internal
