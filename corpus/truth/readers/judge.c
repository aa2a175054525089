// SPDX-License-Identifier: CC0-1.0
//
// Judges two engines of plain floating point by files of the truth set.
//
//     cc -std=c99 -O2 -ffp-contract=off judge.c -o judge -lm
//     gzip -dc incircle.txt.gz | ./judge -
//
//     judge [--engine double|long-double] [--tolerance X] [--json] FILE...
//
// FILE is text without compression, - the standard input. Prints a table for each file, or a line
// of JSON. Returns 0 however many answers are wrong, 1 for a file that cannot be read or is
// malformed, 2 for a wrong command. To judge an engine of your own, give its functions a vt_engine.

// For a clock that ticks in nanoseconds.
#define _POSIX_C_SOURCE 199309L

#include "voroproof_truth_score.h"

#define REAL double
#define ROOT sqrt
#define NAME(x) x##_double
#include "judge_plain.h"
#undef REAL
#undef ROOT
#undef NAME

#define REAL long double
#define ROOT sqrtl
#define NAME(x) x##_long_double
#include "judge_plain.h"
#undef REAL
#undef ROOT
#undef NAME

static const vt_engine engines[] = {
    {"double", incircle_double, exists_double, contact_double, collapse_double, rootorder_double,
     diagram_double},
    {"long-double", incircle_long_double, exists_long_double, contact_long_double,
     collapse_long_double, rootorder_long_double, diagram_long_double}};

static int judge(const char* name, const vt_engine* engine, double tolerance, int json) {
  static vt_record record;
  static vt_score score;
  vt_reader reader;
  FILE* const file = strcmp(name, "-") ? fopen(name, "rb") : stdin;
  if (!file) {
    perror(name);
    return 1;
  }
  if (vt_open(&reader, file)) {
    vt_begin(&score, &reader, engine, tolerance);
    while (vt_next(&reader, &record) && vt_ask(&reader, &record, engine, &score)) continue;
  }
  if (*reader.message) {
    fprintf(stderr, "%s: %s\n", name, reader.message);
  } else if (json) {
    vt_print_json(stdout, &score);
  } else {
    vt_print_text(stdout, &score);
  }
  vt_close(&reader);
  if (file != stdin) fclose(file);
  return *reader.message != 0;
}

static int usage(void) {
  fputs("usage: judge [--engine double|long-double] [--tolerance X] [--json] FILE...\n", stderr);
  return 2;
}

int main(int argc, char** argv) {
  const vt_engine* engine = engines;
  double tolerance = 1e-9;
  int json = 0, bad = 0, i = 1;
  for (; i < argc && !strncmp(argv[i], "--", 2); ++i) {
    if (!strcmp(argv[i], "--json")) {
      json = 1;
    } else if (!strcmp(argv[i], "--engine") && i + 1 < argc) {
      ++i;
      engine = NULL;
      for (size_t k = 0; k < sizeof engines / sizeof *engines; ++k) {
        if (!strcmp(argv[i], engines[k].name)) engine = &engines[k];
      }
      if (!engine) return usage();
    } else if (!strcmp(argv[i], "--tolerance") && i + 1 < argc) {
      char* end;
      tolerance = strtod(argv[++i], &end);
      if (end == argv[i] || *end || !(tolerance >= 0)) return usage();
    } else {
      return usage();
    }
  }
  if (i == argc) return usage();
  for (; i < argc; ++i) bad |= judge(argv[i], engine, tolerance, json);
  return bad;
}
