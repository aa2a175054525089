// Forged indexes. Whoever writes an index may choose all that it says, the hashes included, and a
// shard that begins there sees nothing wrong: here each is certified. They are not joined.
#include <array>
#include <cmath>

#include "certify/part_reader.h"
#include "history/scene_motion.h"
#include "tests/library/indexed_history.h"

namespace voroproof::internal::testing {
namespace {

// An entry of an index, and how many shards there must be for one to begin at its cut.
struct Place {
  Json entry;
  int number = 0, of = 0;
};

class ForgedIndexes : public Indexes {
 protected:
  std::string certificate(const std::string& history) const {
    Claim read = claim(history);
    return std::string(verdict_line(certify(read.scene, *read.history, options_).verdict));
  }

  // Of the k-th entry of the history's index.
  Place place(std::size_t k, const std::string& history = "a.history.jsonl") const {
    index(history);
    Place found{.entry = lines().at(k)};
    const double t = found.entry["cut"]["t"], horizon = scene_.horizon.get_d();
    const double before =
        begin_of_part(found.entry["cut"]["part"].get<std::int64_t>() - 1, history);
    for (found.of = 2; found.of < 1000; ++found.of) {
      found.number = shard_of(t, horizon, found.of);
      if (shard_of(before, horizon, found.of) < found.number) return found;
    }
    throw std::logic_error("no shard begins there");
  }

  // What comes of all shards. Those from that of the place on begin as the entry says, and read
  // another file.
  std::string joined(const Place& place, const Json& entry, const std::string& history,
                     const std::string& rest) const {
    std::vector<std::string> paths;
    for (int k = 1; k <= place.of; ++k) {
      paths.push_back(k < place.number ? shard(k, place.of, history, std::nullopt)
                                       : shard(k, place.of, rest, cut_of(entry)));
      EXPECT_EQ(read_shard(paths.back()).shard.certificate.verdict, Verdict::certified) << k;
    }
    return merged(paths);
  }
  std::string joined(const Place& place, const Json& entry,
                     const std::string& history = "a.history.jsonl") const {
    return joined(place, entry, history, history);
  }

  Json with_hash(const Json& entry) const { return with_hash_of_state(entry, scene_, options_); }

  Replay replay_of(const Json& entry) const {
    Replay replay(scene_, options_);
    replay.read(cut_of(entry));
    return replay;
  }

 private:
  double begin_of_part(std::int64_t part, const std::string& history) const {
    Claim read = claim(history);
    const MotionInput input = motion_input(read.scene);
    std::vector<std::string> remarks;
    PartReader reader(read.scene, input, *read.history, options_, remarks);
    while (static_cast<std::int64_t>(reader.number()) < part) reader.next();
    return reader.begins_at();
  }
};

TEST_F(ForgedIndexes, TheTrueOneIsJoined) {
  for (const std::size_t k : {1, 2, 3}) {
    const Place p = place(k);
    EXPECT_EQ(joined(p, p.entry), "s CERTIFIED") << k;
  }
}

// From the cut on the history is that of another motion, in which one disk has turned back. The
// state of the forged index is that of this motion, so that its shards prove all that comes.
TEST_F(ForgedIndexes, AnotherMotionFromTheCutOn) {
  const Place p = place(2);
  const Replay replay = replay_of(p.entry);
  const Rational t = to_rational(p.entry["cut"]["t"].get<double>());
  Scene other = scene_;
  for (GenId g = 0; g < replay.disks(); ++g) {
    const ExactVec2 c = replay.path(g).at(t), v = replay.velocity(g).value();
    other.disks[g].x = c[0];
    other.disks[g].y = c[1];
    other.disks[g].vx = v[0];
    other.disks[g].vy = v[1];
  }
  other.disks[0].vx = Rational(-other.disks[0].vx.value());
  other.disks[0].vy = Rational(-other.disks[0].vy.value());
  other.horizon = scene_.horizon - t;
  const ClaimedHistory rest = claimed_history(other, run(other));
  ClaimedHistory spliced = history_;
  const Json& cut = p.entry["cut"];
  spliced.events.resize(cut["flips"].get<std::size_t>() + cut["collisions"].get<std::size_t>());
  for (auto event : rest.events) {
    std::visit([&](auto& claim) { claim.t += t.get_d(); }, event);
    spliced.events.push_back(event);
  }
  write("b.history.jsonl", spliced);
  EXPECT_EQ(certificate("b.history.jsonl"), "s REFUTED");
  // The cut is there in this history, too.
  const Place q = place(2, "b.history.jsonl");
  ASSERT_EQ(q.entry["cut"]["offset"], cut["offset"]);
  ASSERT_EQ(q.entry["state"], p.entry["state"]);
  Json forged = q.entry;
  Json& disk = forged["state"]["disks"][0];
  // The path that is at its place at t, with the other velocity.
  const Rational since = replay.path(0).since();
  const ExactVec2 c = replay.path(0).at(t);
  disk[3] = -disk[3].get<double>();
  disk[4] = -disk[4].get<double>();
  disk[5] = since.get_str();
  for (const int axis : {0, 1}) {
    const Rational v = to_rational(disk[3 + axis].get<double>());
    disk[6 + axis] = Rational(c[axis] + v * (since - t)).get_str();
  }
  EXPECT_PRED2(has, joined(q, with_hash(forged), "b.history.jsonl"), "another state");
}

// The same diagram under other numbers: nothing of it is wrong, and it is not what claims lead to.
TEST_F(ForgedIndexes, AnotherTopology) {
  const Place p = place(2);
  Json forged = p.entry;
  Json& state = forged["state"];
  // The half-edges of two V-edges exchanged.
  const auto renamed = [](int h) { return h < 4 ? h ^ 2 : h; };
  const Json before = state;
  for (int h = 0; h < 4; ++h) {
    state["origins"][renamed(h)] = before["origins"][h];
    state["previous"][renamed(h)] = before["previous"][h];
  }
  for (const char* list : {"previous", "anchors"}) {
    for (Json& h : state[list]) h = renamed(h.get<int>());
  }
  EXPECT_PRED2(has, joined(p, with_hash(forged)), "another state");
}

TEST_F(ForgedIndexes, WhatHasHappenedToADisk) {
  const Place p = place(2);
  Json forged = p.entry;
  Json& turns = forged["state"]["disks"][0][1];
  turns = turns.get<int>() + 1;
  EXPECT_PRED2(has, joined(p, with_hash(forged)), "another state");
}

// Two false claims that no shard reads, because the forged index leads past them.
TEST_F(ForgedIndexes, AnOffsetBehindFalseClaims) {
  const Place p = place(2);
  const std::size_t offset = p.entry["cut"]["offset"];
  std::string bytes = directory_.read("a.history.jsonl");
  const std::string next = bytes.substr(offset, bytes.find('\n', offset) - offset);
  const std::string t = next.substr(0, next.find(','));
  const auto line = [&](const Quad& q) {
    std::ostringstream out;
    out << t << ",\"flip\":[" << q.l << ',' << q.r << ',' << q.s << ',' << q.e << "]}\n";
    return out.str();
  };
  const Replay replay = replay_of(p.entry);
  Diagram::HalfEdge h = 0;
  while (!names_an_edge(flipped(replay.diagram().quad(h)))) h += 2;
  const Quad q = replay.diagram().quad(h);
  const std::string garbage = line(q) + line(flipped(q));
  bytes.insert(offset, garbage);
  directory_.write("b.history.jsonl", bytes);
  EXPECT_EQ(certificate("b.history.jsonl"), "s REFUTED");
  const Place there = place(2, "b.history.jsonl");
  ASSERT_EQ(there.entry["cut"], p.entry["cut"]);
  Json forged = there.entry;
  forged["cut"]["offset"] = offset + garbage.size();
  Sha256 read;
  read.add(std::string_view(bytes).substr(0, offset + garbage.size()));
  forged["cut"]["digest"] = read.state();
  EXPECT_PRED2(has, joined(there, forged, "b.history.jsonl"), "another place");
}

// The last line of the history has wrong counts, and the forged index makes up for it.
TEST_F(ForgedIndexes, Counts) {
  std::string bytes = directory_.read("a.history.jsonl");
  const HistoryCounts& counts = history_.claimed_counts;
  const std::string end = "\"flips\":" + std::to_string(counts.flips) +
                          ",\"collisions\":" + std::to_string(counts.collisions);
  const std::string wrong = "\"flips\":" + std::to_string(counts.flips + 1) +
                            ",\"collisions\":" + std::to_string(counts.collisions - 1);
  bytes.replace(bytes.rfind(end), end.size(), wrong);
  directory_.write("b.history.jsonl", bytes);
  EXPECT_EQ(certificate("b.history.jsonl"), "s REFUTED");
  const Place p = place(2, "b.history.jsonl");
  Json forged = p.entry;
  forged["cut"]["flips"] = forged["cut"]["flips"].get<int>() + 1;
  forged["cut"]["collisions"] = forged["cut"]["collisions"].get<int>() - 1;
  EXPECT_PRED2(has, joined(p, forged, "b.history.jsonl"), "other claims");
}

TEST_F(ForgedIndexes, WhatNamesTheCut) {
  const Place p = place(2);
  const auto refused = [&](const std::string& why, const std::function<void(Json&)>& what) {
    Json forged = p.entry;
    what(forged["cut"]);
    EXPECT_PRED2(has, joined(p, forged), why);
  };
  refused("another place", [](Json& c) { c["part"] = c["part"].get<int>() + 1; });
  refused("another place", [](Json& c) { c["t"] = std::nextafter(c["t"].get<double>(), 0); });
  refused("other claims", [](Json& c) { c["line"] = c["line"].get<int>() + 1; });
  refused("other bytes", [](Json& c) {
    c["digest"] = std::string(64, '0') + c["digest"].get<std::string>().substr(64);
  });
}

// The shards read two files: of this scene, with the same claims, and with other first lines.
TEST_F(ForgedIndexes, AnotherHeader) {
  const Place p = place(2);
  ClaimedHistory other = history_;
  other.header.initial.reset();
  write("b.history.jsonl", other);
  const std::int64_t shorter = static_cast<std::int64_t>(directory_.read("a.history.jsonl").size() -
                                                         directory_.read("b.history.jsonl").size());
  // The offsets are made those of the other file by an extension of its header.
  std::string bytes = directory_.read("b.history.jsonl");
  bytes.insert(bytes.find("}\n"), ",\"x-a\":\"" + std::string(shorter - 9, 'x') + "\"");
  directory_.write("b.history.jsonl", bytes);
  ASSERT_EQ(bytes.size(), directory_.read("a.history.jsonl").size());
  EXPECT_PRED2(has, joined(p, p.entry, "a.history.jsonl", "b.history.jsonl"),
               "another beginning of the history");
}

// Whatever the state: a shard ends with a verdict, or refuses it.
TEST_F(ForgedIndexes, AnyStateEndsInAnAnswer) {
  const Place p = place(2);
  Random random(17);
  const auto any = [&](int below) {
    return static_cast<int>(random() % static_cast<unsigned>(below));
  };
  std::array<int, 4> ends{};
  for (int k = 0; k < 400; ++k) {
    Json forged = p.entry;
    Json& state = forged["state"];
    for (int changes = 1 + any(3); changes > 0; --changes) {
      Json& disk = state["disks"][any(8)];
      switch (any(6)) {
        case 0:
          disk[any(3)] = any(3);
          break;
        case 1:
          disk[3 + any(2)] = std::ldexp(any(7) - 3, any(200) - 100);
          break;
        case 2:
          disk[5] = std::ldexp(any(7), any(60) - 30);
          break;
        case 3:
          disk[6 + any(2)] = {std::ldexp(1, any(1000) - 500)};
          break;
        case 4:
          std::swap(disk, state["disks"][any(8)]);
          break;
        default: {
          // Flipped, as no claim has it.
          Diagram diagram = replay_of(p.entry).diagram();
          const Diagram::HalfEdge h = any(2 * diagram.edges());
          if (diagram.quad(h).s == diagram.quad(h).e) break;
          diagram.flip(h);
          for (Diagram::HalfEdge g = 0; g < 2 * diagram.edges(); ++g) {
            state["origins"][g] = diagram.org(g);
            state["previous"][g] = diagram.previous(g);
          }
          for (GenId g = container_id; g < diagram.disks(); ++g) {
            state["anchors"][g + 1] = diagram.anchor(g);
          }
        }
      }
    }
    try {
      const std::string path = shard(p.number, p.of, "a.history.jsonl", cut_of(with_hash(forged)));
      ++ends[static_cast<int>(read_shard(path).shard.certificate.verdict)];
    } catch (const InputError&) {
      ++ends[3];
    }
  }
  EXPECT_GT(ends[static_cast<int>(Verdict::refuted)], 100);
  EXPECT_GT(ends[3], 10);
}

// The contents of two entries exchanged, their places kept; and an entry of another history's
// index. The shards need not be certified then.
TEST_F(ForgedIndexes, TheStateOfAnotherPlace) {
  const Place p = place(2);
  const std::vector<Json> all = lines();
  Json forged = p.entry;
  forged["state"] = all[3]["state"];
  forged["cut"]["state_sha256"] = all[3]["cut"]["state_sha256"];
  const auto refused = [&](const Json& entry, const std::string& history) {
    std::vector<std::string> paths;
    for (int k = 1; k <= p.of; ++k) {
      paths.push_back(shard(k, p.of, k < p.number ? "a.history.jsonl" : history,
                            k < p.number ? std::nullopt : std::optional(cut_of(entry))));
    }
    return merged(paths);
  };
  EXPECT_PRED2(has, refused(forged, "a.history.jsonl"), "another state");
  forged = all[3];
  EXPECT_PRED2(has, refused(forged, "a.history.jsonl"), "another place");
  ClaimedHistory other = history_;
  std::get<FlipEvent>(*std::find_if(other.events.begin(), other.events.end(), [](const auto& e) {
    return std::holds_alternative<FlipEvent>(e);
  })).t += 1e-12;
  write("b.history.jsonl", other);
  const Place q = place(2, "b.history.jsonl");
  EXPECT_PRED2(has, refused(q.entry, "b.history.jsonl"), "does not begin where");
}

}  // namespace
}  // namespace voroproof::internal::testing
