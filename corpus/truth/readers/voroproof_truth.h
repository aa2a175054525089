// SPDX-License-Identifier: CC0-1.0
//
// Reads the truth set (../README.md). C99 and C++, with nothing but the C library; link with -lm.
// voroproof_truth_score.h asks an engine the questions.
//
//     vt_reader reader;
//     vt_record record;
//     if (vt_open(&reader, file)) {  // a file without compression
//       while (vt_next(&reader, &record)) ...
//     }
//     if (*reader.message) ...       // "line 7, field 5: expected a hexadecimal float"
//     vt_close(&reader);
//
// Names that end in _ are not for callers.
#ifndef VOROPROOF_TRUTH_H
#define VOROPROOF_TRUTH_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VT_NAME = 64, VT_ZEROS = 32, VT_MANY = 4096, VT_LINE = 1 << 24 };

typedef enum { VT_INCIRCLE, VT_EXISTS, VT_CONTACT, VT_COLLAPSE, VT_ROOTORDER, VT_STATIC } vt_set;
#define VT_SET_NAMES_ "incircle exists contact collapse rootorder static"

enum { VT_NONE, VT_GRAZE, VT_HIT };  // the kinds of a contact

// Letter d or c with centre and radius, or w with the unit vector (x, y) and the offset r. At rest
// the rates are 0. The plane, the frame of a diagram, has the letter p.
typedef struct {
  char letter;
  double x, y, r, vx, vy, vr;
} vt_generator;

// A time in [lo, hi]; in a collapse also the order of the zero and the sign just after it. An
// engine has lo = hi and need not tell the order.
typedef struct {
  double lo, hi;
  int order, sign;
} vt_zero;

// Pairs with a common edge, and hidden disks. An engine may leave them unsorted.
typedef struct {
  int pairs, hidden;
  int (*pair)[2], *id;
} vt_diagram;

// The answer to any question. Its sign is the kind of a contact, and S0 of a collapse.
typedef struct {
  int sign, zeros;
  vt_zero zero[VT_ZEROS];
  vt_diagram diagram;
} vt_answer;

// A line: the question is `g` with what its set needs besides. Pointers last until the next line.
typedef struct {
  vt_set set;
  char name[VT_NAME];      // CLASS
  int bits, exact;         // BITS, and whether PROOF is `exact`
  int n;                   // generators
  vt_generator *g, frame;  // the frame is that of a static question
  double from[2], to[2];   // the window of a collapse, the two windows of a rootorder
  int root[2][4];          // the generators of the two roots
  vt_answer truth;
} vt_record;

typedef struct {
  FILE* file;
  vt_set set;
  char version[VT_NAME];
  char message[160];   // empty while all is well
  char *text, *block;  // the line, and memory for its arrays
  size_t room, at, stop, block_room, used;
  long line;
  int field;
} vt_reader;

// The message of the first failure. Returns 0.
static inline int vt_fail_(vt_reader* r, const char* expected) {
  if (!*r->message) {
    snprintf(r->message, sizeof r->message,
             r->field ? "line %ld, field %d: expected %s" : "line %ld: %.0d%s", r->line, r->field,
             expected);
  }
  return 0;
}

static inline int vt_line_(vt_reader* r) {
  int c;
  r->at = r->stop = 0;
  r->field = 0;
  ++r->line;
  while ((c = getc(r->file)) != EOF && c != '\n') {
    if (r->stop + 2 > r->room) {
      char* const more = r->room < VT_LINE ? (char*)realloc(r->text, 2 * r->room) : NULL;
      if (!more) return vt_fail_(r, "the line is too long");
      r->text = more;
      r->room *= 2;
    }
    if (c == 0) return vt_fail_(r, "a byte is zero");
    r->text[r->stop++] = (char)c;
  }
  if (ferror(r->file)) return vt_fail_(r, "the file cannot be read");
  if (c == EOF && r->stop == 0) return 0;
  if (r->stop > 0 && r->text[r->stop - 1] == '\r') --r->stop;
  r->text[r->stop] = 0;
  return 1;
}

// The next field. No field is empty; this one is where the line has ended.
static inline const char* vt_field_(vt_reader* r) {
  char* const field = r->text + (r->at < r->stop ? r->at : r->stop);
  const size_t length = strcspn(field, " ");
  ++r->field;
  if (length) r->at += length + 1;
  field[length] = 0;
  return field;
}

static inline int vt_end_(vt_reader* r) {
  ++r->field;
  return r->at == r->stop + 1 || vt_fail_(r, "the end of the line");
}

// The place of the next field in a list of words, else -1.
static inline int vt_word_(vt_reader* r, const char* words) {
  const char* const field = vt_field_(r);
  const size_t length = strlen(field);
  int i = 0;
  for (const char* word = words; word; ++i) {
    if (length && strcspn(word, " ") == length && !memcmp(word, field, length)) return i;
    if ((word = strchr(word, ' ')) != NULL) ++word;
  }
  return vt_fail_(r, words) - 1;
}

// These characters can stand in a table and in JSON.
static inline int vt_name_(vt_reader* r, char name[VT_NAME]) {
  const char* const field = vt_field_(r);
  const size_t length = strlen(field);
  if (length == 0 || length >= VT_NAME ||
      length !=
          strspn(field, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-")) {
    return vt_fail_(r, "a name");
  }
  memcpy(name, field, length + 1);
  return 1;
}

static inline int vt_integer_(vt_reader* r, int low, int high, int* value, const char* expected) {
  const char* const field = vt_field_(r);
  const char* const digits = field + (*field == '-');
  const size_t length = strspn(digits, "0123456789");
  if (length == 0 || length > 9 || digits[length]) return vt_fail_(r, expected);
  *value = atoi(field);
  return (*value >= low && *value <= high) || vt_fail_(r, expected);
}

// -0x1.8p+1, as printf's %a writes it. Not strtod: that minds the locale's decimal point, and takes
// 10, inf and 1e9, which other languages take for something else.
static inline int vt_number_(vt_reader* r, double* value) {
  static const char digits[] = "0123456789abcdef";
  const char* f = vt_field_(r);
  const int minus = *f == '-';
  size_t places = 0;
  unsigned long long bits = 0;
  f += minus;
  if (!strncmp(f, "0x", 2) && strspn(f + 2, digits) == 1) {
    bits = (unsigned long long)(strchr(digits, f[2]) - digits);
    f += 3;
    if (*f == '.') {
      places = strspn(++f, digits);
      if (places == 0 || places > 13) return vt_fail_(r, "a hexadecimal float");
      for (const char* const end = f + places; f < end; ++f)
        bits = 16 * bits + (unsigned long long)(strchr(digits, *f) - digits);
    }
    if (*f == 'p') {
      const char* const power = f + 1 + (f[1] == '+' || f[1] == '-');
      const size_t length = strspn(power, "0123456789");
      if (length > 0 && length < 5 && !power[length]) {
        *value = ldexp(minus ? -(double)bits : (double)bits, atoi(f + 1) - 4 * (int)places);
        if (fabs(*value) <= 1.7976931348623157e308) return 1;
      }
    }
  }
  return vt_fail_(r, "a hexadecimal float");
}

// `count` items of `size` bytes from the memory of the line; NULL if the line is too short for
// them.
static inline void* vt_take_(vt_reader* r, int count, size_t size) {
  const size_t bytes = ((size_t)count * size + 15) / 16 * 16;
  if (bytes > r->block_room - r->used) {
    vt_fail_(r, "a number that the line is long enough for");
    return NULL;
  }
  r->used += bytes;
  return r->block + r->used - bytes;
}

// Three numbers, or six.
static inline int vt_numbers_(vt_reader* r, vt_generator* g, int moving) {
  g->vx = g->vy = g->vr = 0;
  if (!vt_number_(r, &g->x) || !vt_number_(r, &g->y) || !vt_number_(r, &g->r)) return 0;
  if (g->letter != 'w' && !(g->r >= 0)) return vt_fail_(r, "a radius >= 0");
  if (g->letter == 'w' && (g->x * g->y != 0 || fabs(g->x + g->y) != 1))
    return vt_fail_(r, "a wall along an axis");
  if (!moving) return 1;
  if (!vt_number_(r, &g->vx) || !vt_number_(r, &g->vy) || !vt_number_(r, &g->vr)) return 0;
  return g->letter == 'd' || (g->vx == 0 && g->vy == 0 && g->vr == 0) || vt_fail_(r, "rates of 0");
}

// `circle`: the first three have a circle, so that one of them is a disk.
static inline int vt_generators_(vt_reader* r, vt_record* q, int n, int moving, int circle) {
  int containers = 0, walls = 0, disks = 0;
  q->n = n;
  q->g = (vt_generator*)vt_take_(r, n, sizeof *q->g);
  if (!q->g) return 0;
  for (int i = 0; i < n; ++i) {
    const int letter = vt_word_(r, "d c w");
    if (letter < 0) return 0;
    q->g[i].letter = "dcw"[letter];
    if (!vt_numbers_(r, &q->g[i], moving)) return 0;
    containers += letter == 1;
    walls += letter == 2;
    disks += letter == 0 && i < 3;
  }
  if (containers > 1 || (containers && walls)) return vt_fail_(r, "one container and no walls");
  return disks > 0 || !circle || vt_fail_(r, "a disk among the first three");
}

static inline int vt_times_(vt_reader* r, double* from, double* to) {
  if (!vt_number_(r, from) || !vt_number_(r, to)) return 0;
  return *from <= *to || vt_fail_(r, "times in their order");
}

static inline int vt_window_(vt_reader* r, vt_record* q, int number) {
  if (!vt_times_(r, &q->from[number], &q->to[number])) return 0;
  return q->from[number] < q->to[number] || vt_fail_(r, "a window that is not empty");
}

static inline int vt_sign_(vt_reader* r, vt_record* q) {
  return vt_integer_(r, -1, 1, &q->truth.sign, "a sign");
}

static inline int vt_incircle_(vt_reader* r, vt_record* q) {
  return vt_sign_(r, q) && vt_generators_(r, q, 4, 0, 1);
}

static inline int vt_exists_(vt_reader* r, vt_record* q) {
  return vt_sign_(r, q) && vt_generators_(r, q, 3, 0, 1);
}

static inline int vt_contact_(vt_reader* r, vt_record* q) {
  if ((q->truth.sign = vt_word_(r, "none graze hit")) < 0) return 0;
  q->truth.zeros = q->truth.sign != VT_NONE;
  q->truth.zero[0].sign = q->truth.zero[0].order = 0;
  if (q->truth.sign == VT_NONE) {
    if (vt_word_(r, "-") || vt_word_(r, "-")) return 0;
  } else if (!vt_times_(r, &q->truth.zero[0].lo, &q->truth.zero[0].hi)) {
    return 0;
  }
  return vt_generators_(r, q, 2, 1, 0);
}

static inline int vt_collapse_(vt_reader* r, vt_record* q) {
  if (!vt_sign_(r, q)) return 0;
  if (q->truth.sign == 0) return vt_fail_(r, "1 or -1");
  if (!vt_integer_(r, 0, VT_ZEROS, &q->truth.zeros, "a number of zeros")) return 0;
  for (int i = 0, sign = q->truth.sign; i < q->truth.zeros; ++i) {
    vt_zero* const z = &q->truth.zero[i];
    if (!vt_times_(r, &z->lo, &z->hi)) return 0;
    if (!vt_integer_(r, 1, 99, &z->order, "an order")) return 0;
    if (z->order % 2) sign = -sign;
    if (!vt_integer_(r, sign, sign, &z->sign, "another sign, for this order")) return 0;
  }
  return vt_window_(r, q, 0) && vt_generators_(r, q, 4, 1, 1);
}

static inline int vt_rootorder_(vt_reader* r, vt_record* q) {
  int n, most = 0;
  if (!vt_sign_(r, q)) return 0;
  for (int i = 0; i < 8; ++i) {
    int* const id = &q->root[i / 4][i % 4];
    if (i % 4 == 0 && !vt_window_(r, q, i / 4)) return 0;
    if (!vt_integer_(r, 0, VT_MANY - 1, id, "the number of a generator")) return 0;
    if (*id > most) most = *id;
  }
  return vt_integer_(r, most + 1, VT_MANY, &n, "more generators") && vt_generators_(r, q, n, 1, 0);
}

static inline int vt_ids_in_order_(const void* a, const void* b) {
  return (*(const int*)a > *(const int*)b) - (*(const int*)a < *(const int*)b);
}

static inline int vt_pairs_in_order_(const void* a, const void* b) {
  const int first = vt_ids_in_order_(a, b);
  return first ? first : vt_ids_in_order_((const int*)a + 1, (const int*)b + 1);
}

static inline void vt_sort_(vt_diagram* d) {
  if (d->pairs > 0) qsort(d->pair, (size_t)d->pairs, sizeof *d->pair, vt_pairs_in_order_);
  if (d->hidden > 0) qsort(d->id, (size_t)d->hidden, sizeof *d->id, vt_ids_in_order_);
}

static inline int vt_static_(vt_reader* r, vt_record* q) {
  vt_diagram* const d = &q->truth.diagram;
  const int frame = vt_word_(r, "p c");
  memset(&q->frame, 0, sizeof q->frame);
  if (frame < 0) return 0;
  q->frame.letter = "pc"[frame];
  if (frame && !vt_numbers_(r, &q->frame, 0)) return 0;
  if (!vt_integer_(r, 0, VT_MANY, &q->n, "a number of disks")) return 0;
  if (!(q->g = (vt_generator*)vt_take_(r, q->n, sizeof *q->g))) return 0;
  for (int i = 0; i < q->n; ++i) {
    q->g[i].letter = 'd';
    if (!vt_numbers_(r, &q->g[i], 0)) return 0;
  }
  if (!vt_integer_(r, 0, q->n * (q->n + 1) / 2, &d->pairs, "a number of pairs")) return 0;
  if (!(d->pair = (int(*)[2])vt_take_(r, d->pairs, sizeof *d->pair))) return 0;
  for (int i = 0; i < d->pairs; ++i) {
    int* const p = d->pair[i];
    if (!vt_integer_(r, -frame, q->n - 1, &p[0], "an id")) return 0;
    if (!vt_integer_(r, p[0] + 1, q->n - 1, &p[1], "a larger id")) return 0;
    if (i && vt_pairs_in_order_(p - 2, p) >= 0) return vt_fail_(r, "pairs in their order");
  }
  if (!vt_integer_(r, 0, q->n, &d->hidden, "a number of hidden disks")) return 0;
  if (!(d->id = (int*)vt_take_(r, d->hidden, sizeof *d->id))) return 0;
  for (int i = 0; i < d->hidden; ++i) {
    if (!vt_integer_(r, 0, q->n - 1, &d->id[i], "an id")) return 0;
  }
  vt_sort_(d);
  return 1;
}

// Reads the first line. 1, or 0 with a message. Then, too, the reader wants to be closed.
static inline int vt_open(vt_reader* r, FILE* file) {
  int set;
  memset(r, 0, sizeof *r);
  r->file = file;
  r->room = 256;
  if (!(r->text = (char*)malloc(r->room))) return vt_fail_(r, "no memory");
  if (!vt_line_(r)) return vt_fail_(r, "the file is empty");
  if (vt_word_(r, "#") || vt_word_(r, "voroproof-truth")) return 0;
  if ((set = vt_word_(r, VT_SET_NAMES_)) < 0) return 0;
  r->set = (vt_set)set;
  return vt_name_(r, r->version) && vt_end_(r);
}

// The next line that is no comment. 0 at the end of the file, or with a message.
static inline int vt_next(vt_reader* r, vt_record* q) {
  static int (*const rest[])(vt_reader*, vt_record*) = {vt_incircle_, vt_exists_,    vt_contact_,
                                                        vt_collapse_, vt_rootorder_, vt_static_};
  do {
    if (*r->message || !vt_line_(r)) return 0;
  } while (*r->text == '#');
  if (r->block_room < 4 * r->stop + 256) {
    free(r->block);
    r->block_room = 8 * r->stop + 256;
    if (!(r->block = (char*)malloc(r->block_room))) return vt_fail_(r, "no memory");
  }
  r->used = 0;
  q->set = r->set;
  q->truth.zeros = q->truth.diagram.pairs = q->truth.diagram.hidden = 0;
  if (!vt_name_(r, q->name)) return 0;
  if (!vt_integer_(r, 0, 99999999, &q->bits, "a number of bits")) return 0;
  if ((q->exact = vt_word_(r, "interval exact")) < 0) return 0;
  return rest[r->set](r, q) && vt_end_(r);
}

static inline void vt_close(vt_reader* r) {
  free(r->text);
  free(r->block);
  r->text = r->block = NULL;
}

#endif
