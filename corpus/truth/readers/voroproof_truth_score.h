// SPDX-License-Identifier: CC0-1.0
//
// Asks an engine the questions of the truth set, counts its wrong answers, and prints the table.
// An example is judge.c.
//
//     vt_score score;
//     vt_begin(&score, &reader, &engine, 1e-9);
//     while (vt_next(&reader, &record) && vt_ask(&reader, &record, &engine, &score)) continue;
//     vt_print_text(stdout, &score);
//
// A caller may define VT_NOW() as a clock of nanoseconds, a double.
#ifndef VOROPROOF_TRUTH_SCORE_H
#define VOROPROOF_TRUTH_SCORE_H

#include <time.h>

#include "voroproof_truth.h"

#ifndef VT_NOW
#define VT_NOW() vt_now_()
// clock() ticks only each microsecond: for C99 define _POSIX_C_SOURCE as 199309L to have better.
static inline double vt_now_(void) {
#if defined CLOCK_MONOTONIC
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
#elif defined TIME_UTC
  struct timespec now;
  timespec_get(&now, TIME_UTC);
  return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
#else
  return (double)clock() * (1e9 / CLOCKS_PER_SEC);
#endif
}
#endif

enum { VT_CLASSES = 64 };

// Callbacks, which may be NULL. All set *undecided to 1 where they cannot tell.
typedef struct {
  const char* name;
  int (*incircle)(const vt_generator g[4], int* undecided);
  int (*exists)(const vt_generator g[3], int* undecided);
  // The kind, and the time of what is not VT_NONE.
  int (*contact)(const vt_generator g[2], double* time, int* undecided);
  // How many zeros there are. Writes S0 and, of the zeros, VT_ZEROS at most.
  int (*collapse)(const vt_generator g[4], double t0, double t1, int* s0, vt_zero zero[VT_ZEROS],
                  int* undecided);
  int (*rootorder)(const vt_record* question, int* undecided);
  // There is room for all pairs and all ids.
  void (*diagram)(const vt_generator* frame, int n, const vt_generator* disks, vt_diagram* answer,
                  int* undecided);
} vt_engine;

// A question counts in one column: undecided; none or some where the answer has too few or too many
// of what there is (a circle, a contact, zeros, pairs, hidden disks); sign; time.
enum { VT_RIGHT, VT_SIGN, VT_NO, VT_SOME, VT_TIME, VT_UNDECIDED, VT_VERDICTS };
#define VT_VERDICT_NAMES_ "queries wrong_sign wrong_none wrong_some wrong_time undecided"

typedef struct {
  char name[VT_NAME];
  long long count[VT_VERDICTS];
  double nanoseconds;  // those of the engine, and of one look at the clock for each
} vt_class;

typedef struct {
  vt_set set;
  char version[VT_NAME];
  const char* engine;
  double tolerance;  // a time t is right within tolerance * (1 + |t|) of [lo, hi]
  int classes;
  vt_class of[VT_CLASSES];  // in the order of the file
} vt_score;

static inline void vt_begin(vt_score* score, const vt_reader* reader, const vt_engine* engine,
                            double tolerance) {
  memset(score, 0, sizeof *score);
  score->set = reader->set;
  memcpy(score->version, reader->version, sizeof score->version);
  score->engine = engine->name;
  score->tolerance = tolerance;
}

// Whether the engine has an answer to the questions of this set.
static inline int vt_has(const vt_engine* e, vt_set set) {
  return (set == VT_INCIRCLE && e->incircle) || (set == VT_EXISTS && e->exists) ||
         (set == VT_CONTACT && e->contact) || (set == VT_COLLAPSE && e->collapse) ||
         (set == VT_ROOTORDER && e->rootorder) || (set == VT_STATIC && e->diagram);
}

// Returns whether the answer is undecided.
static inline int vt_answer_(const vt_engine* e, const vt_record* q, vt_answer* a) {
  int undecided = 0;
  a->zeros = 0;
  a->sign = 0;
  if (q->set == VT_INCIRCLE) a->sign = e->incircle(q->g, &undecided);
  if (q->set == VT_EXISTS) a->sign = e->exists(q->g, &undecided);
  if (q->set == VT_CONTACT) {
    double time = 0;
    a->sign = e->contact(q->g, &time, &undecided);
    a->zeros = a->sign != VT_NONE;
    a->zero[0].lo = a->zero[0].hi = time;
    a->zero[0].sign = 0;
  }
  if (q->set == VT_COLLAPSE) {
    a->zeros = e->collapse(q->g, q->from[0], q->to[0], &a->sign, a->zero, &undecided);
  }
  if (q->set == VT_ROOTORDER) a->sign = e->rootorder(q, &undecided);
  if (q->set == VT_STATIC) e->diagram(&q->frame, q->n, q->g, &a->diagram, &undecided);
  return undecided;
}

// Whether an item of the second sorted array is not in the first one.
static inline int vt_lacks_(const void* in, int m, const void* items, int n, size_t size,
                            int (*order)(const void*, const void*)) {
  for (int i = 0; i < n; ++i) {
    const void* const item = (const char*)items + (size_t)i * size;
    if (m == 0 || !bsearch(item, in, (size_t)m, size, order)) return 1;
  }
  return 0;
}

// Whether the second diagram has something that the first one lacks.
static inline int vt_less_(const vt_diagram* a, const vt_diagram* b) {
  return vt_lacks_(a->pair, a->pairs, b->pair, b->pairs, sizeof *a->pair, vt_pairs_in_order_) ||
         vt_lacks_(a->id, a->hidden, b->id, b->hidden, sizeof *a->id, vt_ids_in_order_);
}

static inline int vt_verdict_(const vt_record* q, const vt_answer* a, double tolerance) {
  const vt_answer* const t = &q->truth;
  int has = a->zeros, had = t->zeros;
  if (q->set == VT_STATIC) {
    return vt_less_(&a->diagram, &t->diagram)   ? VT_NO
           : vt_less_(&t->diagram, &a->diagram) ? VT_SOME
                                                : VT_RIGHT;
  }
  if (q->set == VT_EXISTS) has = a->sign > 0, had = t->sign > 0;
  if (has != had) return has < had ? VT_NO : VT_SOME;
  if (a->sign != t->sign) return VT_SIGN;
  for (int i = 0; i < t->zeros; ++i) {
    if (a->zero[i].sign != t->zero[i].sign) return VT_SIGN;
  }
  for (int i = 0; i < t->zeros; ++i) {
    const double time = a->zero[i].lo, reach = tolerance * (1 + fabs(time));
    if (!(t->zero[i].lo - reach <= time && time <= t->zero[i].hi + reach)) return VT_TIME;
  }
  return VT_RIGHT;
}

static inline vt_class* vt_class_(vt_score* score, const char* name) {
  int i = 0;
  while (i < score->classes && strcmp(score->of[i].name, name)) ++i;
  if (i == VT_CLASSES) return NULL;
  if (i == score->classes) memcpy(score->of[score->classes++].name, name, VT_NAME);
  return &score->of[i];
}

// Asks, and counts the answer. 1, or 0 with the reader's message.
static inline int vt_ask(vt_reader* reader, const vt_record* q, const vt_engine* engine,
                         vt_score* score) {
  vt_class* const of = vt_class_(score, q->name);
  vt_answer answer;
  double begin, end;
  int undecided;
  if (!of) return vt_fail_(reader, "there are too many classes");
  if (!vt_has(engine, q->set)) return vt_fail_(reader, "the engine has no answers to this set");
  memset(&answer.diagram, 0, sizeof answer.diagram);
  if (q->set == VT_STATIC) {
    const size_t n = (size_t)q->n + 1;
    answer.diagram.pair = (int(*)[2])malloc(n * n / 2 * sizeof *answer.diagram.pair + 1);
    answer.diagram.id = (int*)malloc(n * sizeof *answer.diagram.id);
    if (!answer.diagram.pair || !answer.diagram.id) return vt_fail_(reader, "no memory");
  }
  begin = VT_NOW();
  undecided = vt_answer_(engine, q, &answer);
  end = VT_NOW();
  vt_sort_(&answer.diagram);
  ++of->count[undecided ? VT_UNDECIDED : vt_verdict_(q, &answer, score->tolerance)];
  of->nanoseconds += end - begin;
  free(answer.diagram.pair);
  free(answer.diagram.id);
  return 1;
}

// A word of a list with one blank between, and its length.
static inline int vt_word_of_(const char* words, int number, const char** word) {
  for (; number > 0; --number) words = strchr(words, ' ') + 1;
  *word = words;
  return (int)strcspn(words, " ");
}

static inline long long vt_queries(const vt_class* c) {
  long long sum = 0;
  for (int i = 0; i < VT_VERDICTS; ++i) sum += c->count[i];
  return sum;
}

static inline void vt_print_row_(FILE* out, int width, const vt_class* c) {
  const long long queries = vt_queries(c);
  fprintf(out, "%-*s %10lld", width, c->name, queries);
  for (int i = 1; i < VT_VERDICTS; ++i) fprintf(out, " %10lld", c->count[i]);
  fprintf(out, " %10.0f\n", queries ? c->nanoseconds / (double)queries : 0);
}

// A heading, a row for each class in the order of the file, and one for all of them.
static inline void vt_print_text(FILE* out, const vt_score* score) {
  vt_class all;
  const char* word;
  int width = 5, length = vt_word_of_(VT_SET_NAMES_, score->set, &word);
  memset(&all, 0, sizeof all);
  memcpy(all.name, "all", 4);
  fprintf(out, "%.*s %s, engine %s, tolerance %g\n", length, word, score->version, score->engine,
          score->tolerance);
  for (int i = 0; i < score->classes; ++i) {
    const vt_class* const c = &score->of[i];
    if ((int)strlen(c->name) > width) width = (int)strlen(c->name);
    for (int k = 0; k < VT_VERDICTS; ++k) all.count[k] += c->count[k];
    all.nanoseconds += c->nanoseconds;
  }
  fprintf(out, "%-*s", width, "class");
  for (int i = 0; i < VT_VERDICTS; ++i) {
    length = vt_word_of_(VT_VERDICT_NAMES_, i, &word);
    fprintf(out, " %*.*s", 10, length, word);
  }
  fprintf(out, " %10s\n", "ns/query");
  for (int i = 0; i < score->classes; ++i) vt_print_row_(out, width, &score->of[i]);
  vt_print_row_(out, width, &all);
}

// One line of JSON. The name of the engine must need no escapes.
static inline void vt_print_json(FILE* out, const vt_score* score) {
  const char* word;
  int length = vt_word_of_(VT_SET_NAMES_, score->set, &word);
  fprintf(out, "{\"format\":\"voroproof-truth-score\",\"version\":1,\"set\":\"%.*s\",", length,
          word);
  fprintf(out, "\"set_version\":\"%s\",\"engine\":\"%s\",\"tolerance\":%g,\"classes\":[",
          score->version, score->engine, score->tolerance);
  for (int i = 0; i < score->classes; ++i) {
    const vt_class* const c = &score->of[i];
    fprintf(out, "%s{\"class\":\"%s\"", i ? "," : "", c->name);
    for (int k = 0; k < VT_VERDICTS; ++k) {
      length = vt_word_of_(VT_VERDICT_NAMES_, k, &word);
      fprintf(out, ",\"%.*s\":%lld", length, word, k ? c->count[k] : vt_queries(c));
    }
    fprintf(out, ",\"nanoseconds\":%.0f}", c->nanoseconds);
  }
  fprintf(out, "]}\n");
}

#endif
