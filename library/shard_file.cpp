#include "library/shard_file.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "certify/evidence/evidence.h"
#include "history/error.h"
#include "library/report_reader.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* shard_format = "voroproof-shard";
constexpr std::size_t max_shard_bytes = std::size_t{1} << 26;

Json json(const std::optional<Cut>& cut) {
  if (!cut) return nullptr;
  return {{"part", cut->part},
          {"t", cut->t},
          {"flips", cut->claims.flips},
          {"collisions", cut->claims.collisions},
          {"maneuvers", cut->claims.maneuvers},
          {"line", cut->line},
          {"offset", cut->offset},
          {"header_sha256", cut->header_sha256},
          {"bytes_sha256", cut->bytes_sha256},
          {"state_sha256", cut->state_sha256}};
}

std::string read_hash(const JsonField& field) {
  std::string hash = field.text();
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos) {
    field.fail("not 64 hexadecimal digits");
  }
  return hash;
}

std::optional<Cut> read_cut(const JsonField& field) {
  if (field.json().is_null()) return std::nullopt;
  return Cut{.part = read_count(field["part"]),
             .t = field["t"].number(),
             .claims = {read_count(field["flips"]), read_count(field["collisions"]),
                        read_count(field["maneuvers"])},
             .line = read_count(field["line"]),
             .offset = read_count(field["offset"]),
             .header_sha256 = read_hash(field["header_sha256"]),
             .bytes_sha256 = read_hash(field["bytes_sha256"]),
             .state_sha256 = read_hash(field["state_sha256"])};
}

int read_small(const JsonField& field, int least, int most) {
  const std::int64_t number = field.integer();
  if (number < least || number > most) field.fail("out of range");
  return static_cast<int>(number);
}

// Which of what two cuts are made of is not the same.
std::string difference(const Cut& a, const Cut& b) {
  if (a.header_sha256 != b.header_sha256) return "another beginning of the history";
  if (a.part != b.part || a.t != b.t || a.offset != b.offset) return "another place";
  if (a.bytes_sha256 != b.bytes_sha256) return "other bytes before it";
  if (a.claims != b.claims || a.line != b.line) return "other claims before it";
  return "another state";
}

// Why the shard does not go on where the one before it, which is certified, has ended; empty if it
// does.
std::string break_between(const Shard& before, const Shard& after) {
  if (before.end == after.begin) return {};
  if (!before.end) return "begins where the history is over";
  if (!after.begin) return "begins where the history is over, and the one before it ends earlier";
  return "does not begin where the one before it ends: " + difference(*before.end, *after.begin);
}

}  // namespace

std::optional<std::pair<int, int>> part_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto whole = [&](std::size_t from, std::size_t to) {
    int value = 0;
    const char* const last = text.data() + to;
    const auto [end, error] = std::from_chars(text.data() + from, last, value);
    return error == std::errc() && end == last ? value : 0;
  };
  const int number = whole(0, slash), of = whole(slash + 1, text.size());
  if (number < 1 || of < number || of > most_shards) return std::nullopt;
  return std::pair(number, of);
}

std::string about_shard(const ShardFile& file, const std::string& about) {
  return "shard " + std::to_string(file.number) + " of " + std::to_string(file.of) + " of " + about;
}

std::string shard_text(const ShardFile& file) {
  const Certificate& c = file.shard.certificate;
  Json j = Json::object();
  j["format"] = shard_format;
  j["version"] = 1;
  j["part"] = Json::array({file.number, file.of});
  j["unoriented"] = file.options.unoriented;
  j["max_bits"] = file.options.motion.max_bits;
  j["other_horizon"] = nullptr;
  if (c.other_horizon) {
    j["other_horizon"] =
        Json::array({(*c.other_horizon)[0].get_str(), (*c.other_horizon)[1].get_str()});
  }
  j["begin"] = json(file.shard.begin);
  j["end"] = json(file.shard.end);
  // It is no report by itself: what it says is of the shard.
  Json report = Json::parse(report_text(file.run, file.options, c));
  report["format"] = "shard-report";
  report["words"]["about"] = about_shard(file, report["words"]["about"]);
  j["report"] = std::move(report);
  return j.dump(1) + "\n";
}

ShardFile read_shard(const std::string& path) {
  const nlohmann::json document = read_report(path, shard_format, max_shard_bytes);
  const JsonField field(document, path);
  ShardFile file;
  file.of = read_small(field["part"][1], 1, most_shards);
  file.number = read_small(field["part"][0], 1, file.of);
  const JsonField report = field["report"];
  file.run = read_run(report);
  file.options = read_options(report);
  if (!field["unoriented"].json().is_boolean()) field["unoriented"].fail("neither true nor false");
  file.options.unoriented = field["unoriented"].json().get<bool>();
  file.options.motion.max_bits = read_small(field["max_bits"], 1, 1 << 24);
  Shard& shard = file.shard;
  shard.begin = read_cut(field["begin"]);
  shard.end = read_cut(field["end"]);
  shard.certificate = read_certificate(report);
  if (const JsonField horizons = field["other_horizon"]; !horizons.json().is_null()) {
    shard.certificate.other_horizon = std::array{read_exact(horizons[0]), read_exact(horizons[1])};
  }
  if (!shard.begin && (shard.end || shard.certificate.prefix_events > 0 ||
                       shard.certificate.verdict != Verdict::certified)) {
    field["begin"].fail("nothing is left of the history, and something was certified");
  }
  return file;
}

std::string difference(const ShardFile& a, const ShardFile& b) {
  const CertificationRun &r = a.run, &s = b.run;
  if (r.producer != s.producer) return "by another version of the program";
  if (r.scene_sha256 != s.scene_sha256 || r.disks != s.disks) return "of another scene";
  if (r.horizon != s.horizon || r.history_producer != s.history_producer ||
      a.shard.certificate.other_horizon != b.shard.certificate.other_horizon) {
    return "of another history";
  }
  const CertifyOptions &o = a.options, &p = b.options;
  if (o.truth != p.truth || o.events != p.events) return "of another truth";
  if (o.tolerance != p.tolerance || o.law_tolerance != p.law_tolerance || o.strict != p.strict ||
      o.unoriented != p.unoriented || o.motion.max_bits != p.motion.max_bits) {
    return "with other options";
  }
  return {};
}

void append(Shard& shard, Shard&& next) {
  // A shard without a part has nothing to add.
  if (next.begin != next.end || next.certificate.verdict != Verdict::certified) {
    append(shard.certificate, std::move(next.certificate));
  }
  shard.end = std::move(next.end);
}

ShardFile merge_shards(const std::vector<std::string>& paths) {
  std::vector<std::pair<ShardFile, std::string>> files;
  for (const std::string& path : paths) files.emplace_back(read_shard(path), path);
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return a.first.number < b.first.number; });
  const auto refuse = [](const std::string& path, const std::string& why) {
    throw InputError(path, 0, "", why);
  };
  std::optional<ShardFile> whole;
  for (auto& [file, path] : files) {
    const int next = whole ? whole->number + 1 : 1;
    const std::string name = std::to_string(file.number) + " of " + std::to_string(file.of);
    if (whole && file.of != whole->of) {
      refuse(path, "is shard " + name + ", and others are of " + std::to_string(whole->of));
    }
    if (whole && file.number < next) refuse(path, "is shard " + name + ", which is there twice");
    const bool decided = whole && whole->shard.certificate.verdict != Verdict::certified;
    if (file.number > next && !decided) {
      refuse(path, "is shard " + name + ", and shard " + std::to_string(next) + " is missing");
    }
    if (!decided && file.shard.certificate.divergence) {
      const EvidenceCheck check = check_evidence(*file.shard.certificate.divergence);
      if (check.evidence == Evidence::contradicted) {
        refuse(path, "is shard " + name + ", and its witness is false (" + check.sentence + ")");
      }
    }
    if (!whole) {
      if (!file.shard.begin || file.shard.begin->part != 0 || file.shard.begin->claims.all() != 0) {
        refuse(path, "is shard " + name + " and does not begin with the history");
      }
      whole = std::move(file);
      continue;
    }
    if (const std::string why = difference(*whole, file); !why.empty()) {
      refuse(path, "is " + why + " than the shards before it");
    }
    whole->number = file.number;
    if (decided) continue;
    if (const std::string why = break_between(whole->shard, file.shard); !why.empty()) {
      refuse(path, "shard " + name + " " + why);
    }
    append(whole->shard, std::move(file.shard));
    whole->run.history_sha256 = file.run.history_sha256;
  }
  if (whole->shard.certificate.verdict == Verdict::certified) {
    if (whole->number != whole->of) {
      refuse(paths.back(), "shard " + std::to_string(whole->number + 1) + " of " +
                               std::to_string(whole->of) + " is missing");
    }
    if (whole->shard.end) refuse(paths.back(), "the last shard does not end with the history");
  }
  return std::move(*whole);
}

}  // namespace voroproof::internal
