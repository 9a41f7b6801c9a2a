/* Steps of a bladder in C: the yardstick of the runtime's speed.
 *
 * 27 x 27 free nodes of 1 kg in an anchored frame, chains of 28 springs both ways, constant pressure, gravity, velocity
 * Verlet. Structure of arrays, one row after the other, each spring once. The work is the runtime's: pressure as the
 * gradient of the enclosed volume (3 cross products a facet), positions and velocities with what rounding dropped from
 * them. -DPLAIN leaves both out: equal shares of a facet's vector area (1 cross product), plain sums.
 *
 * Build: cc -O3 -march=native -DREAL=float|double [-DPLAIN -ffast-math] [-fno-math-errno -fno-trapping-math] sheet.c -lm
 * Use: sheet <steps> <turns>; prints ns a step (least, median) and the height of the middle.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define N 29             /* nodes a side, frame included */
#define S 32             /* numbers a row */
#define PAD 8            /* numbers before the first row, so that every node has a neighbour to the left */
#define ROWS (N + 1)     /* one row beyond, never moved */
#define LEN (PAD + ROWS * S + PAD)
typedef REAL R;
#define SQRT(x) (sizeof(R) == 4 ? (R)sqrtf((float)(x)) : (R)sqrt((double)(x)))
static const R H = (R)1e-4, K = 5000, L = (R)0.05, P = 2000, G = (R)-9.81;

typedef struct { R c[3][LEN] __attribute__((aligned(64))); } Row3;
static Row3 x, xr, v, vr, w, f;          /* w: 1/mass, 0 where a node is fixed */
static R kr[LEN], ku[LEN], cell[LEN];    /* stiffness to the right and up, pressure of a cell; 0 where there is none */
static inline int at(int r, int c) { return PAD + r * S + c; }

static void setup(void) {
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < S; c++) {
            int k = at(r, c), inner = r > 0 && c > 0 && r < N - 1 && c < N - 1;
            x.c[0][k] = c * L; x.c[1][k] = r * L;
            x.c[2][k] = inner ? (R)(0.01 * sin(0.3 * c) * cos(0.2 * r)) : 0;
            for (int d = 0; d < 3; d++) w.c[d][k] = inner;
            kr[k] = r > 0 && r < N - 1 && c < N - 1 ? K : 0;
            ku[k] = c > 0 && c < N - 1 && r < N - 1 ? K : 0;
            int corner = (r == 0 || r == N - 2) && (c == 0 || c == N - 2);
            cell[k] = r < N - 1 && c < N - 1 && !corner ? P : 0;
        }
}

/* Elastic forces of a row of springs from node k to node k + way, on their tails. */
static inline void pull(int k, int way, const R *stiffness, R o[3][S]) {
    for (int i = 0; i < S; i++) {
        R d[3], l2 = 0;
        for (int c = 0; c < 3; c++) { d[c] = x.c[c][k + i + way] - x.c[c][k + i]; l2 += d[c] * d[c]; }
        R l = SQRT(l2), s = stiffness[k + i] * (l - L), q = 1 / l;
        for (int c = 0; c < 3; c++) o[c][i] = d[c] * q * s;
    }
}

/* Forces of the pressure on the corners a (here), b (right), c (right above), d (above) of a row of cells. */
static inline void push(int k, R a[3][S], R b[3][S], R c[3][S], R d[3][S]) {
    for (int i = 0; i < S; i++) {
        R p[3], q[3], g[3], n[3], side[3], along[3], pressure = cell[k + i];
        for (int j = 0; j < 3; j++) {
            const R *y = x.c[j] + k + i;
            p[j] = y[S + 1] - y[0]; q[j] = y[S] - y[1]; g[j] = (y[0] + y[S + 1]) - (y[1] + y[S]);
        }
        for (int j = 0; j < 3; j++) {
            int m = (j + 1) % 3, o = (j + 2) % 3;
            n[j] = p[m] * q[o] - p[o] * q[m];
            side[j] = q[m] * g[o] - q[o] * g[m];
            along[j] = p[m] * g[o] - p[o] * g[m];
        }
        for (int j = 0; j < 3; j++) {
            R e = n[j] * (R)0.125;
#ifdef PLAIN
            a[j][i] = b[j][i] = c[j][i] = d[j][i] = e * pressure; (void)side; (void)along;
#else
            const R t = (R)(1.0 / 24);
            a[j][i] = (e + side[j] * t) * pressure; c[j][i] = (e - side[j] * t) * pressure;
            b[j][i] = (e + along[j] * t) * pressure; d[j][i] = (e - along[j] * t) * pressure;
#endif
        }
    }
}

static void forces(void) {
    static R right[3][PAD + S], up[2][3][S], cells[2][4][3][PAD + S];
    R part[4][3][S], to_right[3][S];
    memset(up, 0, sizeof up); memset(cells, 0, sizeof cells); memset(right, 0, sizeof right);
    for (int r = 0; r < N; r++) {
        int k = at(r, 0), now = r & 1, old = !now;
        pull(k, 1, kr, to_right);
        pull(k, S, ku, up[now]);
        push(k, part[0], part[1], part[2], part[3]);
        for (int j = 0; j < 3; j++) {
            memcpy(right[j] + PAD, to_right[j], sizeof to_right[j]);
            for (int n = 0; n < 4; n++) memcpy(cells[now][n][j] + PAD, part[n][j], sizeof part[n][j]);
        }
        for (int j = 0; j < 3; j++) {
            const R *a = cells[now][0][j] + PAD, *b = cells[now][1][j] + PAD, *c = cells[old][2][j] + PAD,
                    *d = cells[old][3][j] + PAD, *to = right[j] + PAD, *above = up[now][j], *below = up[old][j];
            for (int i = 0; i < S; i++)
                f.c[j][k + i] = (j == 2 ? G : 0) - to[i - 1] + to[i] - below[i] + above[i] + c[i - 1] + d[i] + b[i - 1] + a[i];
        }
    }
}

static void step(void) {
    static Row3 half;
    for (int j = 0; j < 3; j++)
        for (int i = PAD; i < PAD + N * S; i++) {
            R m = v.c[j][i] + H / 2 * (f.c[j][i] * w.c[j][i]);
            half.c[j][i] = m;
#ifdef PLAIN
            x.c[j][i] += H * m;
#else
            R d = H * m + xr.c[j][i], s = x.c[j][i] + d, t = s - x.c[j][i];
            xr.c[j][i] = (x.c[j][i] - (s - t)) + (d - t);
            x.c[j][i] = s;
#endif
        }
    forces();
    for (int j = 0; j < 3; j++)
        for (int i = PAD; i < PAD + N * S; i++) {
            R m = half.c[j][i] + H / 2 * (f.c[j][i] * w.c[j][i]);
#ifdef PLAIN
            v.c[j][i] = m;
#else
            R d = (m - v.c[j][i]) + vr.c[j][i], s = v.c[j][i] + d, t = s - v.c[j][i];
            vr.c[j][i] = (v.c[j][i] - (s - t)) + (d - t);
            v.c[j][i] = s;
#endif
        }
}

static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * t.tv_sec + t.tv_nsec; }
static int before(const void *a, const void *b) { double d = *(double *)a - *(double *)b; return (d > 0) - (d < 0); }

int main(int argc, char **argv) {
    int steps = argc > 1 ? atoi(argv[1]) : 100, turns = argc > 2 ? atoi(argv[2]) : 100;
    double *took = malloc(turns * sizeof *took);
    setup();
    forces();
    for (int n = 0; n < turns; n++) {
        double start = now();
        for (int s = 0; s < steps; s++) step();
        took[n] = (now() - start) / steps;
    }
    qsort(took, turns, sizeof *took, before);
    printf("%.1f %.1f %.9g\n", took[0], took[turns / 2], (double)x.c[2][at(N / 2, N / 2)]);
    free(took);
    return 0;
}
