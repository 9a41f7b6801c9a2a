/* Steps of bladders in C: the yardstick of the runtime's speed.
 *
 * 27 x 27 free nodes of 1 kg in an anchored frame, chains of 28 springs both ways, constant pressure, gravity, velocity
 * Verlet. Structure of arrays, one row after the other, each spring once. The work is the runtime's: pressure as the
 * gradient of the enclosed volume (3 cross products a facet), positions and velocities with what rounding dropped from
 * them. -DPLAIN leaves both out: equal shares of a facet's vector area (1 cross product), plain sums.
 *
 * -DLANES=n: n bladders side by side, a number of each in a register, instead of a bladder's numbers.
 *
 * Build: cc -O3 -march=native -DREAL=float|double [-DPLAIN -ffast-math] [-fno-math-errno -fno-trapping-math] sheet.c -lm -pthread
 * Use: sheet <steps> <turns> [<bladders> <threads>]; prints ns a step of each bladder (least, median) and the height of the
 * middle. Bladders take their steps one bladder after the other, every thread those of its share.
 */
#include <math.h>
#include <pthread.h>
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
#ifdef LANES
typedef R T __attribute__((vector_size(LANES * sizeof(R))));
static inline T root(T a) { for (int l = 0; l < LANES; l++) a[l] = SQRT(a[l]); return a; }
#define FIRST(a) (a)[0]
#else
#define LANES 1
typedef R T;
static inline T root(T a) { return SQRT(a); }
#define FIRST(a) (a)
#endif
static const R H = (R)1e-4, K = 5000, L = (R)0.05, P = 2000, G = (R)-9.81;

typedef struct { T c[3][LEN] __attribute__((aligned(64))); } Row3;
typedef struct {
    Row3 x, xr, v, vr, w, f, half;          /* w: 1/mass, 0 where a node is fixed; half: velocities half a step on */
    T kr[LEN], ku[LEN], cell[LEN];          /* stiffness to the right and up, pressure of a cell; 0 where there is none */
} Sheet;
static inline int at(int r, int c) { return PAD + r * S + c; }

static void setup(Sheet *b) {
    const T one = (T){0} + 1;
    memset(b, 0, sizeof *b);
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < S; c++) {
            int k = at(r, c), inner = r > 0 && c > 0 && r < N - 1 && c < N - 1;
            b->x.c[0][k] = (T){0} + c * L; b->x.c[1][k] = (T){0} + r * L;
            b->x.c[2][k] = (T){0} + (inner ? (R)(0.01 * sin(0.3 * c) * cos(0.2 * r)) : 0);
            for (int d = 0; d < 3; d++) b->w.c[d][k] = (T){0} + (R)inner;
            b->kr[k] = r > 0 && r < N - 1 && c < N - 1 ? one * K : one * 0;
            b->ku[k] = c > 0 && c < N - 1 && r < N - 1 ? one * K : one * 0;
            int corner = (r == 0 || r == N - 2) && (c == 0 || c == N - 2);
            b->cell[k] = r < N - 1 && c < N - 1 && !corner ? one * P : one * 0;
        }
}

/* Elastic forces of a row of springs from node k to node k + way, on their tails. */
static inline void pull(const Sheet *restrict b, int k, int way, const T *stiffness, T (*restrict o)[S]) {
    for (int i = 0; i < S; i++) {
        T d[3], l2 = {0};
        for (int c = 0; c < 3; c++) { d[c] = b->x.c[c][k + i + way] - b->x.c[c][k + i]; l2 += d[c] * d[c]; }
        T l = root(l2), s = stiffness[k + i] * (l - L), q = (R)1 / l;
        for (int c = 0; c < 3; c++) o[c][i] = d[c] * q * s;
    }
}

/* Forces of the pressure on the corners a (here), b (right), c (right above), d (above) of a row of cells. */
static inline void push(const Sheet *restrict b, int k, T (*restrict on_a)[S], T (*restrict on_b)[S], T (*restrict on_c)[S],
                        T (*restrict on_d)[S]) {
    for (int i = 0; i < S; i++) {
        T p[3], q[3], g[3], n[3], side[3], along[3], pressure = b->cell[k + i];
        for (int j = 0; j < 3; j++) {
            const T *y = b->x.c[j] + k + i;
            p[j] = y[S + 1] - y[0]; q[j] = y[S] - y[1]; g[j] = (y[0] + y[S + 1]) - (y[1] + y[S]);
        }
        for (int j = 0; j < 3; j++) {
            int m = (j + 1) % 3, o = (j + 2) % 3;
            n[j] = p[m] * q[o] - p[o] * q[m];
            side[j] = q[m] * g[o] - q[o] * g[m];
            along[j] = p[m] * g[o] - p[o] * g[m];
        }
        for (int j = 0; j < 3; j++) {
            T e = n[j] * (R)0.125;
#ifdef PLAIN
            on_a[j][i] = on_b[j][i] = on_c[j][i] = on_d[j][i] = e * pressure; (void)side; (void)along;
#else
            const R t = (R)(1.0 / 24);
            on_a[j][i] = (e + side[j] * t) * pressure; on_c[j][i] = (e - side[j] * t) * pressure;
            on_b[j][i] = (e + along[j] * t) * pressure; on_d[j][i] = (e - along[j] * t) * pressure;
#endif
        }
    }
}

static void forces(Sheet *restrict b) {
    T right[3][PAD + S], up[2][3][S], cells[2][4][3][PAD + S], part[4][3][S], to_right[3][S];
    memset(up, 0, sizeof up); memset(cells, 0, sizeof cells); memset(right, 0, sizeof right);
    for (int r = 0; r < N; r++) {
        int k = at(r, 0), now = r & 1, old = !now;
        pull(b, k, 1, b->kr, to_right);
        pull(b, k, S, b->ku, up[now]);
        push(b, k, part[0], part[1], part[2], part[3]);
        for (int j = 0; j < 3; j++) {
            memcpy(right[j] + PAD, to_right[j], sizeof to_right[j]);
            for (int n = 0; n < 4; n++) memcpy(cells[now][n][j] + PAD, part[n][j], sizeof part[n][j]);
        }
        for (int j = 0; j < 3; j++) {
            const T *here = cells[now][0][j] + PAD, *left = cells[now][1][j] + PAD, *both = cells[old][2][j] + PAD,
                    *down = cells[old][3][j] + PAD, *to = right[j] + PAD, *above = up[now][j], *below = up[old][j];
            for (int i = 0; i < S; i++)
                b->f.c[j][k + i] = (j == 2 ? G : 0) - to[i - 1] + to[i] - below[i] + above[i] + both[i - 1] + down[i] + left[i - 1] + here[i];
        }
    }
}

static void step(Sheet *restrict b) {
    for (int j = 0; j < 3; j++)
        for (int i = PAD; i < PAD + N * S; i++) {
            T m = b->v.c[j][i] + H / 2 * (b->f.c[j][i] * b->w.c[j][i]);
            b->half.c[j][i] = m;
#ifdef PLAIN
            b->x.c[j][i] += H * m;
#else
            T d = H * m + b->xr.c[j][i], s = b->x.c[j][i] + d, t = s - b->x.c[j][i];
            b->xr.c[j][i] = (b->x.c[j][i] - (s - t)) + (d - t);
            b->x.c[j][i] = s;
#endif
        }
    forces(b);
    for (int j = 0; j < 3; j++)
        for (int i = PAD; i < PAD + N * S; i++) {
            T m = b->half.c[j][i] + H / 2 * (b->f.c[j][i] * b->w.c[j][i]);
#ifdef PLAIN
            b->v.c[j][i] = m;
#else
            T d = (m - b->v.c[j][i]) + b->vr.c[j][i], s = b->v.c[j][i] + d, t = s - b->v.c[j][i];
            b->vr.c[j][i] = (b->v.c[j][i] - (s - t)) + (d - t);
            b->v.c[j][i] = s;
#endif
        }
}

static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * t.tv_sec + t.tv_nsec; }
static int before(const void *a, const void *b) { double d = *(double *)a - *(double *)b; return (d > 0) - (d < 0); }

/* What a thread does: so many steps of its sheets. */
typedef struct { Sheet *sheets; int count, steps; } Share;
static void *run(void *data) {
    Share *share = data;
    for (int n = 0; n < share->count; n++)
        for (int s = 0; s < share->steps; s++) step(&share->sheets[n]);
    return NULL;
}

int main(int argc, char **argv) {
    int steps = argc > 1 ? atoi(argv[1]) : 100, turns = argc > 2 ? atoi(argv[2]) : 100;
    int bladders = argc > 3 ? atoi(argv[3]) : LANES, threads = argc > 4 ? atoi(argv[4]) : 1;
    int count = (bladders + LANES - 1) / LANES, each = (count + threads - 1) / threads;
    Sheet *sheets = aligned_alloc(64, count * sizeof *sheets);
    double *took = malloc(turns * sizeof *took);
    pthread_t *running = malloc(threads * sizeof *running);
    Share *shares = malloc(threads * sizeof *shares);
    for (int n = 0; n < count; n++) { setup(&sheets[n]); forces(&sheets[n]); }
    for (int i = 0; i < threads; i++) {
        int first = i * each < count ? i * each : count, end = first + each < count ? first + each : count;
        shares[i] = (Share){sheets + first, end - first, steps};
    }
    for (int n = 0; n < turns; n++) {
        double start = now();
        for (int i = 1; i < threads; i++) pthread_create(&running[i], NULL, run, &shares[i]);
        run(&shares[0]);
        for (int i = 1; i < threads; i++) pthread_join(running[i], NULL);
        took[n] = (now() - start) / steps / (count * LANES);
    }
    qsort(took, turns, sizeof *took, before);
    printf("%.1f %.1f %.9g\n", took[0], took[turns / 2], (double)FIRST(sheets[count - 1].x.c[2][at(N / 2, N / 2)]));
    return 0;
}
