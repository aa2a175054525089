// SPDX-License-Identifier: CC0-1.0
//
// An engine in plain floating point, wrong where numbers are close: it shows how. judge.c includes
// this file once for each type, with REAL the type, ROOT its square root, and NAME(x) a name.
//
// voroproof_truth.py and voroproof_truth.mjs have the same engine in double, with the same
// operations in the same order, so that all three make the same mistakes. Therefore there are only
// + - * / and the square root, which IEEE 754 rounds in one way; no hypot, and no sines. Compile
// with -ffp-contract=off: a fused a * b + c is another number.

// A generator seen from a base disk, as a function of time: (x, y), s and p are the differences of
// centre and radius and the tangency, and p has p0, p1, p2 as coefficients. With n the direction
// from the base to the centre of a circle, and 2 k the reciprocal of the distance, the circle
// touches where x n_x + y n_y + s = 2 k p. A wall is the limit of growing disks. All numbers of a
// container are negated, so that p is positive: then no formula has an exception for it.
typedef struct {
  REAL x, y, s, vx, vy, vs, p0, p1, p2;
} NAME(row);

static NAME(row) NAME(row_of)(const vt_generator* b, const vt_generator* g) {
  NAME(row) w;
  if (g->letter == 'w') {
    w.x = -(REAL)g->x;
    w.y = -(REAL)g->y;
    w.s = 1;
    w.vx = w.vy = w.vs = 0;
    w.p0 = 2 * ((REAL)g->x * b->x + (REAL)g->y * b->y - g->r + b->r);
    w.p1 = 2 * ((REAL)g->x * b->vx + (REAL)g->y * b->vy + b->vr);
    w.p2 = 0;
    return w;
  }
  w.x = (REAL)g->x - b->x;
  w.y = (REAL)g->y - b->y;
  w.s = (g->letter == 'c' ? -(REAL)g->r : (REAL)g->r) - b->r;
  w.vx = (REAL)g->vx - b->vx;
  w.vy = (REAL)g->vy - b->vy;
  w.vs = (REAL)g->vr - b->vr;
  w.p0 = w.x * w.x + w.y * w.y - w.s * w.s;
  w.p1 = 2 * (w.x * w.vx + w.y * w.vy - w.s * w.vs);
  w.p2 = w.vx * w.vx + w.vy * w.vy - w.vs * w.vs;
  if (g->letter == 'c') {
    w.x = -w.x, w.y = -w.y, w.s = -w.s, w.vx = -w.vx, w.vy = -w.vy, w.vs = -w.vs;
    w.p0 = -w.p0, w.p1 = -w.p1, w.p2 = -w.p2;
  }
  return w;
}

// Where a row is at time t.
static NAME(row) NAME(row_at)(const NAME(row) * w, REAL t) {
  NAME(row) now = *w;
  now.x = w->x + w->vx * t;
  now.y = w->y + w->vy * t;
  now.s = w->s + w->vs * t;
  now.p0 = w->p0 + t * (w->p1 + t * w->p2);
  return now;
}

// The rows of n generators after the first three are rotated so that a disk is the base.
static void NAME(rows_of)(const vt_generator* g, int n, NAME(row) * rows) {
  const int base = g[0].letter == 'd' ? 0 : g[1].letter == 'd' ? 1 : 2;
  for (int k = 1; k < n; ++k) {
    rows[k - 1] = NAME(row_of)(&g[base], &g[k < 3 ? (base + k) % 3 : k]);
  }
}

static int NAME(sign)(REAL x, int* undecided) {
  if (x != x) *undecided = 1;
  return (x > 0) - (x < 0);
}

// The gap between the circle and generator e at time t, times something positive.
static REAL NAME(gap)(const NAME(row) rows[3], REAL t) {
  const NAME(row) j = NAME(row_at)(&rows[0], t), k = NAME(row_at)(&rows[1], t);
  const NAME(row) e = NAME(row_at)(&rows[2], t);
  const REAL xp = j.x * k.p0 - j.p0 * k.x, yp = j.y * k.p0 - j.p0 * k.y;
  const REAL sp = j.s * k.p0 - j.p0 * k.s, xs = j.x * k.s - j.s * k.x;
  const REAL ys = j.y * k.s - j.s * k.y, xy = j.x * k.y - j.y * k.x;
  const REAL square = xp * xp + yp * yp - sp * sp;
  const REAL root = square > 0 ? ROOT(square) : 0;
  const REAL a = e.x * sp - e.s * xp + e.p0 * xs, b = e.y * sp - e.s * yp + e.p0 * ys;
  const REAL c = e.x * yp - e.y * xp + e.p0 * xy;
  return xp * a + yp * b + root * c;
}

static int NAME(incircle)(const vt_generator g[4], int* undecided) {
  NAME(row) rows[3];
  NAME(rows_of)(g, 4, rows);
  return NAME(sign)(NAME(gap)(rows, 0), undecided);
}

static int NAME(exists)(const vt_generator g[3], int* undecided) {
  NAME(row) rows[2];
  NAME(rows_of)(g, 3, rows);
  const NAME(row) j = rows[0], k = rows[1];
  const REAL xp = j.x * k.p0 - j.p0 * k.x, yp = j.y * k.p0 - j.p0 * k.y;
  const REAL sp = j.s * k.p0 - j.p0 * k.s, xs = j.x * k.s - j.s * k.x;
  const REAL ys = j.y * k.s - j.s * k.y, xy = j.x * k.y - j.y * k.x;
  const REAL square = xp * xp + yp * yp - sp * sp;
  const REAL root = square > 0 ? ROOT(square) : 0;
  return NAME(sign)(xp * xs + yp * ys + root * xy, undecided);
}

// The first time t >= 0 at which a t^2 + 2 b t + c, not negative at 0, becomes so. Not a number
// where the numbers are too large.
static int NAME(first_fall)(REAL a, REAL b, REAL c, REAL* time) {
  *time = 0;
  if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return VT_HIT;
  const REAL d = b * b - a * c;
  *time = d;
  if (d != d) return VT_NONE;
  *time = 0;
  if (a >= 0 && (b >= 0 || d < 0)) return VT_NONE;
  const REAL root = d > 0 ? ROOT(d) : 0;
  *time = b < 0 ? c / (root - b) : (b + root) / -a;
  return a > 0 && d == 0 ? VT_GRAZE : VT_HIT;
}

static int NAME(contact)(const vt_generator g[2], double* time, int* undecided) {
  const vt_generator *i = &g[0], *j = &g[1];
  REAL t = 0;
  int kind = VT_NONE;
  if (i->letter != 'd') i = &g[1], j = &g[0];
  if (i->letter != 'd') return VT_NONE;
  if (j->letter == 'w') {
    const REAL c = (REAL)j->x * i->x + (REAL)j->y * i->y - j->r - i->r;
    const REAL b = (REAL)j->x * i->vx + (REAL)j->y * i->vy - i->vr;
    kind = NAME(first_fall)(0, b / 2, c, &t);
  } else {
    const REAL x = (REAL)j->x - i->x, y = (REAL)j->y - i->y;
    const REAL vx = (REAL)j->vx - i->vx, vy = (REAL)j->vy - i->vy;
    const REAL s = j->letter == 'c' ? (REAL)j->r - i->r : (REAL)j->r + i->r;
    const REAL vs = j->letter == 'c' ? -(REAL)i->vr : (REAL)j->vr + i->vr;
    const REAL a = vx * vx + vy * vy - vs * vs, b = x * vx + y * vy - s * vs;
    const REAL c = x * x + y * y - s * s;
    if (j->letter == 'd') kind = NAME(first_fall)(a, b, c, &t);
    if (j->letter == 'c') {
      // A disk never grazes its container from inside. It may fill it just when it touches.
      kind = NAME(first_fall)(-a, -b, -c, &t);
      if (kind != VT_HIT && t == t && vs < 0) kind = VT_HIT, t = s / -vs;
      if (kind == VT_GRAZE) kind = VT_NONE;
    }
  }
  if (t != t) *undecided = 1;
  *time = (double)t;
  return kind;
}

// Where the gap has the other sign than `sign` between lo and hi.
static REAL NAME(change)(const NAME(row) rows[3], REAL lo, REAL hi, int sign) {
  for (;;) {
    const REAL mid = (lo + hi) / 2;
    if (!(lo < mid && mid < hi)) return hi;
    const REAL value = NAME(gap)(rows, mid);
    if (sign > 0 ? value > 0 : value < 0) {
      lo = mid;
    } else {
      hi = mid;
    }
  }
}

// Looks at 64 steps for changes of the sign. It misses zeros of even order, and pairs of zeros
// between two steps; more steps take longer, and miss them, too.
static int NAME(collapse)(const vt_generator g[4], double t0, double t1, int* s0, vt_zero* zero,
                          int* undecided) {
  enum { STEPS = 64 };
  NAME(row) rows[3];
  int zeros = 0, touching = 0, sign;
  REAL before = t0;
  NAME(rows_of)(g, 4, rows);
  *s0 = sign = NAME(sign)(NAME(gap)(rows, before), undecided);
  if (sign == 0) *undecided = 1;
  for (int i = 1; i <= STEPS && !*undecided; ++i) {
    const REAL t = i == STEPS ? (REAL)t1 : t0 + ((REAL)t1 - t0) * i / STEPS;
    const int now = NAME(sign)(NAME(gap)(rows, t), undecided);
    if (now != sign && !touching) {
      if (zeros < VT_ZEROS) {
        zero[zeros].lo = (double)(now == 0 ? t : NAME(change)(rows, before, t, sign));
      }
      ++zeros;
    }
    touching = now == 0;
    if (now != 0) sign = now;
    if (zeros > 0 && zeros <= VT_ZEROS) zero[zeros - 1].sign = sign;
    before = t;
  }
  return zeros;
}

// The tangency of two generators as a polynomial in time.
static void NAME(tangency)(const vt_generator* i, const vt_generator* j, REAL p[3]) {
  p[0] = p[1] = p[2] = 0;
  if (i->letter == 'w' && j->letter == 'w') {
    const REAL x = (REAL)i->x - j->x, y = (REAL)i->y - j->y;
    p[0] = x * x + y * y;
    return;
  }
  const NAME(row) w = i->letter == 'd' ? NAME(row_of)(i, j) : NAME(row_of)(j, i);
  p[0] = w.p0, p[1] = w.p1, p[2] = w.p2;
}

// The cotangency of four generators at time t, from the tangencies 01 23 02 13 03 12.
static REAL NAME(cotangency)(REAL p[6][3], REAL t) {
  REAL at[6];
  for (int i = 0; i < 6; ++i) at[i] = p[i][0] + t * (p[i][1] + t * p[i][2]);
  const REAL u = at[0] * at[1], v = at[2] * at[3], w = at[4] * at[5], d = u - v - w;
  return d * d - 4 * v * w;
}

// The one root between lo and hi: where the sign changes, else where the value is least.
static REAL NAME(root)(const vt_record* q, int number) {
  REAL p[6][3], lo = q->from[number], hi = q->to[number];
  const int* const id = q->root[number];
  static const int order[12] = {0, 1, 2, 3, 0, 2, 1, 3, 0, 3, 1, 2};
  for (int i = 0; i < 6; ++i) {
    NAME(tangency)(&q->g[id[order[2 * i]]], &q->g[id[order[2 * i + 1]]], p[i]);
  }
  const REAL first = NAME(cotangency)(p, lo), last = NAME(cotangency)(p, hi);
  if (first == 0) return lo;
  if (last == 0) return hi;
  if ((first < 0) != (last < 0)) {
    for (;;) {
      const REAL mid = (lo + hi) / 2;
      if (!(lo < mid && mid < hi)) return hi;
      const REAL value = NAME(cotangency)(p, mid);
      if (first > 0 ? value > 0 : value < 0) {
        lo = mid;
      } else {
        hi = mid;
      }
    }
  }
  // Golden sections, 48 of them: the width falls by 1e-10, beyond what the value can tell.
  const REAL golden = (REAL)0.6180339887498949, turn = first < 0 ? -1 : 1;
  REAL a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
  REAL at_a = turn * NAME(cotangency)(p, a), at_b = turn * NAME(cotangency)(p, b);
  for (int i = 0; i < 48; ++i) {
    if (at_a < at_b) {
      hi = b, b = a, at_b = at_a;
      a = hi - golden * (hi - lo);
      at_a = turn * NAME(cotangency)(p, a);
    } else {
      lo = a, a = b, at_a = at_b;
      b = lo + golden * (hi - lo);
      at_b = turn * NAME(cotangency)(p, b);
    }
  }
  return (lo + hi) / 2;
}

static int NAME(rootorder)(const vt_record* q, int* undecided) {
  const REAL a = NAME(root)(q, 0), b = NAME(root)(q, 1);
  (void)undecided;
  return (a > b) - (a < b);
}

// Whether disk i lies in another one, or outside of the container.
static int NAME(is_hidden)(const vt_generator* frame, int n, const vt_generator* d, int i) {
  for (int j = -1; j < n; ++j) {
    const vt_generator* const o = j < 0 ? frame : &d[j];
    const REAL x = (REAL)o->x - d[i].x, y = (REAL)o->y - d[i].y;
    const REAL s = j < 0 ? -(REAL)o->r - d[i].r : (REAL)o->r - d[i].r;
    const REAL p = x * x + y * y - s * s;
    if (j < 0 && o->letter == 'c' && p >= 0) return 1;
    if (j >= 0 && j != i && p <= 0 && (s > 0 || (s == 0 && j < i))) return 1;
  }
  return 0;
}

// Grows with the angle of (x, y), from 0 to 4.
static REAL NAME(turn)(REAL x, REAL y) {
  if (x == 0 && y == 0) return 0;
  if (y >= 0) return x >= 0 ? y / (x + y) : 1 - x / (y - x);
  return x < 0 ? 2 + y / (x + y) : 3 + x / (x - y);
}

// Sight from a disk: in the direction n a generator with x n_x + y n_y + s = k p is first at the
// distance 1 / (2 k), so that the neighbours are those whose k, a sine wave, is the largest
// somewhere. `w` has x / p, y / p and s / p of all generators, the frame last, the plane as zeros;
// `pieces` has room for 2 (n + 2) ends. Whether wave j is above all others on more than points.
static int NAME(is_neighbour)(int n, REAL (*w)[3], const char* skip, int j, REAL* pieces) {
  REAL *now = pieces, *next = pieces + 2 * (n + 2);
  int count = 1;
  now[0] = 0, now[1] = 4;
  for (int k = 0; k <= n && count > 0; ++k) {
    if (k == j || skip[k]) continue;
    const REAL a = w[j][0] - w[k][0], b = w[j][1] - w[k][1], c = w[j][2] - w[k][2];
    const REAL d = a * a + b * b - c * c, root = d > 0 ? ROOT(d) : 0;
    // It is above wave k between the angles u and v, counterclockwise.
    const REAL u = NAME(turn)(root * b - c * a, -(root * a) - c * b);
    const REAL v = NAME(turn)(-(root * b) - c * a, root * a - c * b);
    if (!(d > 0) || !(u < v || v < u)) {
      if (!(c > 0)) return 0;
      continue;
    }
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      const REAL lo = now[2 * i], hi = now[2 * i + 1];
      const REAL ends[2][2] = {{u < v ? u : 0, v}, {u < v ? 4 : u, 4}};
      for (int side = 0; side < 2; ++side) {
        const REAL from = lo > ends[side][0] ? lo : ends[side][0];
        const REAL to = hi < ends[side][1] ? hi : ends[side][1];
        if (from < to) next[2 * kept] = from, next[2 * kept + 1] = to, ++kept;
      }
    }
    REAL* const swap = now;
    now = next, next = swap, count = kept;
  }
  return count > 0;
}

static void NAME(diagram)(const vt_generator* frame, int n, const vt_generator* d, vt_diagram* to,
                          int* undecided) {
  const int contained = frame->letter == 'c';
  char* const skip = (char*)calloc((size_t)n + 1, 1);
  REAL(*const w)[3] = (REAL(*)[3])malloc(((size_t)n + 1) * sizeof *w);
  REAL* const pieces = (REAL*)malloc(4 * ((size_t)n + 2) * sizeof *pieces);
  *undecided = !skip || !w || !pieces;
  for (int i = 0; i < n && !*undecided; ++i) {
    skip[i] = (char)NAME(is_hidden)(frame, n, d, i);
    if (skip[i]) to->id[to->hidden++] = i;
  }
  for (int i = 0; i < n && !*undecided; ++i) {
    if (skip[i]) continue;
    skip[i] = 1;
    for (int k = 0; k <= n; ++k) {
      w[k][0] = w[k][1] = w[k][2] = 0;
      if (k < n ? skip[k] : !contained) continue;
      const NAME(row) row = NAME(row_of)(&d[i], k < n ? &d[k] : frame);
      w[k][0] = row.x / row.p0, w[k][1] = row.y / row.p0, w[k][2] = row.s / row.p0;
    }
    for (int k = contained ? -1 : 0; k < n; ++k) {
      if (k >= 0 && (k <= i || skip[k])) continue;
      if (!NAME(is_neighbour)(n, w, skip, k < 0 ? n : k, pieces)) continue;
      to->pair[to->pairs][0] = k < 0 ? k : i;
      to->pair[to->pairs++][1] = k < 0 ? i : k;
    }
    skip[i] = 0;
  }
  free(skip);
  free(w);
  free(pieces);
}
