// A history of a world, replayed instant by instant, as the certifier does it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "certify/world/world_courses.h"
#include "certify/world/world_lives.h"
#include "certify/world/world_map.h"
#include "certify/world/world_verdict.h"
#include "exact/names.h"
#include "history/world_history.h"

namespace voroproof::internal {

// Functions throw WorldRefuted and WorldUndecided.
class WorldReplay {
 public:
  // Enters the instant 0, for which `initial` is the diagram just after it.
  WorldReplay(const World& world, const std::vector<Quad>& initial, bool filters);

  // The time of the next instant; null where nothing more happens up to the horizon, the present
  // one apart. Precondition: no instant is open.
  const LazyTime* next();
  // Enters it: what the scene says takes effect. Precondition: there is one.
  void open();
  bool is_open() const { return now_.has_value(); }
  const LazyTime& at() const { return now_->t; }
  // Whether the event is one of the open instant, whatever time it claims; then it is done.
  bool take(const WorldEvent& event);
  // Why the last event was not one of an instant.
  const std::string& why_not() const { return why_not_; }
  // Leaves the open instant: proves the diagram just after it.
  void close();

  const WorldVerdict::Counts& checked() const { return checked_; }

 private:
  struct Instant {
    LazyTime t;
    bool at_start = false;
    std::vector<Scheduled> scheduled{};  // not claimed yet
    std::vector<Swap> meetings{};        // two disks that become one
    std::vector<Swap> swaps{};           // that are to be told
    std::vector<Swap> told{};            // that were
    std::set<Quad> collapsing{};         // edges that are known to flip
    std::set<int> edges{};               // to be followed anew, as far as they are there
    std::set<GenId> jumped{};            // that jump, come or go
    std::set<GenId> turned{};            // so are all edges in or at these cells,
    std::set<GenId> centres{};           // and these are proved, with their neighbours
    std::set<GenId> around{};            // and with these
    std::set<GenId> hidden{};            // disks that have to have another host
    bool proves_cells = false;
  };

  // Entering.
  void take_due(const WorldAgenda::Item& item);
  void take_scheduled(const Scheduled& change);
  void touch(GenId g, GenId h);
  void coincide(GenId i, GenId j);
  void expect_swap(const Swap& meeting);
  void stir(GenId g);
  void see_alone();

  // Claims.
  bool claim(const Quad& flip);
  bool claim(const Hide& hide);
  bool claim(const Appear& appear);
  bool claim(const Swap& swap);
  bool claim(const PathTurn& turn);
  bool claim(const Jump& jump);
  bool refuse(std::string why);
  bool is_disk(GenId g) const { return g >= 0 && g < map_.disks(); }
  bool falls_at(GenId g, GenId h) const;
  bool is_about_to_hide(GenId g) const;
  Scheduled* scheduled(GenId g, bool turn);
  void forget(const Scheduled& change);
  void take_steps(const std::vector<Step>& steps, const char* which);
  void drop_unseen_swaps();
  void jump_out(const Jump& jump);
  void jump_in(const Jump& jump);

  // Leaving.
  void require_nothing_left() const;
  void renew_edges();
  void renew_hidden();
  void renew_last_disk();
  void prove_cells();
  bool find_host(GenId g);
  bool is_host(GenId g, GenId h) const;
  Rational time_after();

  WorldCourses motion_;
  WorldMap map_;
  WorldAgenda agenda_;
  std::size_t next_scheduled_ = 0;
  std::vector<GenId> hosts_;  // those of hidden disks
  std::optional<Instant> now_;
  std::optional<LazyTime> next_;
  std::string why_not_;
  WorldVerdict::Counts checked_;
};

}  // namespace voroproof::internal
