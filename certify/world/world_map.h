// The diagram of a world's visible disks as a history tells it: its dual, a triangulation of the
// sphere, with the notation of exact/topology/diagram.h, and the steps of world histories.
//
// Steps are done wherever incidences allow it. Whether they are right is asked elsewhere; what they
// changed is kept for that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/generators.h"
#include "exact/topology/diagram.h"
#include "history/world_history.h"

namespace voroproof::internal {

class WorldMap {
 public:
  using Half = std::int32_t;

  // No disk is visible.
  explicit WorldMap(int disks) : visible_(disks, false), anchor_(disks + 1, -1) {}
  // All disks with edges in it are visible. Throws std::invalid_argument where the edges are not
  // those of a diagram of two disks or more.
  WorldMap(int disks, const std::vector<Quad>& edges);

  int disks() const { return static_cast<int>(visible_.size()); }
  // The number of visible disks; there are edges from two on.
  int count() const { return count_; }
  bool is_visible(GenId g) const { return g < 0 || visible_[g]; }
  bool has_edges() const { return count_ >= 2; }
  std::vector<GenId> visible() const;

  // By numbers of edges: those that are gone are passed over.
  int edge_numbers() const { return static_cast<int>(halves_.size() / 2); }
  bool is_edge(int number) const {
    return number < edge_numbers() && halves_[2 * number].previous >= 0;
  }

  static Half twin(Half h) { return h ^ 1; }
  Half previous(Half h) const { return halves_[h].previous; }
  Half next(Half h) const { return previous(previous(h)); }
  GenId org(Half h) const { return halves_[h].org; }
  GenId dest(Half h) const { return org(twin(h)); }
  GenId apex(Half h) const { return org(previous(h)); }
  Quad quad(Half h) const { return {org(h), dest(h), apex(twin(h)), apex(h)}; }
  // The next half-edge counterclockwise around org(h).
  Half rotate(Half h) const { return twin(previous(h)); }
  // The half-edges that start at g, in that order; none where it has no edge.
  std::vector<Half> ring(GenId g) const;
  // The number of edges of its cell, or `most`.
  int degree(GenId g, int most) const;
  // The half-edge of this name, or -1.
  Half find(const Quad& q) const;
  std::vector<GenId> neighbours(GenId g) const;

  // False where the incidences do not allow it: then nothing is changed.
  bool flip(const Quad& q);
  bool hide(const Hide& hide);
  bool appear(const Appear& appear);
  bool exchange(GenId i, GenId j);
  bool step(const Step& step);
  // A disk beside at most one visible one.
  void show(GenId g);
  void remove_few(GenId g);

  // Since the last call of begin_instant(): numbers of edges whose name has changed, which may be
  // gone since, and generators whose cell has.
  void begin_instant();
  const std::vector<int>& changed_edges() const { return changed_edges_; }
  const std::vector<GenId>& changed_cells() const { return changed_cells_; }

 private:
  struct HalfEdge {
    GenId org;
    Half previous;  // -1: the edge is gone
  };

  Half new_edge(GenId a, GenId b);
  void delete_edge(Half h);
  void link(Half a, Half b, Half c);
  void start(GenId a, GenId b);
  void insert(Half h, GenId g);
  void remove(GenId g);
  void set_visible(GenId g, bool visible);
  void note_edge(Half h) { changed_edges_.push_back(h / 2); }
  void note_cell(GenId g) { changed_cells_.push_back(g); }

  std::vector<HalfEdge> halves_;
  std::vector<Half> free_;  // numbers of halves of edges that are gone, the even ones
  std::vector<bool> visible_;
  int count_ = 0;
  std::vector<Half> anchor_;
  std::vector<int> changed_edges_;
  std::vector<GenId> changed_cells_;
};

}  // namespace voroproof::internal
