/* Steps of a list of springs in C: the yardstick of bodies that are no grids.
 *
 * Points and springs as `tests/benches/springs.rs` writes them, 1 kg, K = 1000 N/m, velocity Verlet, one spring after
 * the other as anybody would write it; positions and velocities with what rounding dropped from them, as the runtime has.
 *
 * Build: cc -O3 -march=native -DREAL=float|double -fno-math-errno -fno-trapping-math springs.c -lm
 * Use: springs <file> <steps> <turns>; prints the least ns a step and spring and the height of the first point.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef REAL R;
#define SQRT(x) (sizeof(R) == 4 ? (R)sqrtf((float)(x)) : (R)sqrt((double)(x)))
static const R H = (R)1e-3, K = 1000;
typedef struct { R c[3]; } Vec;
typedef struct { int tail, head; R length; } Spring;
static int points, springs;
static Vec *x, *xr, *v, *vr, *half, *f;
static Spring *spring;

static void forces(void) {
    for (int i = 0; i < points; i++) f[i].c[0] = f[i].c[1] = f[i].c[2] = 0;
    for (int s = 0; s < springs; s++) {
        const Spring *p = &spring[s];
        R d[3], l2 = 0;
        for (int c = 0; c < 3; c++) { d[c] = x[p->head].c[c] - x[p->tail].c[c]; l2 += d[c] * d[c]; }
        R l = SQRT(l2), pull = K * (l - p->length) / l;
        for (int c = 0; c < 3; c++) { f[p->tail].c[c] += pull * d[c]; f[p->head].c[c] -= pull * d[c]; }
    }
}

/* a += change, with what rounding drops. */
static inline void add(R *a, R *rest, R change) {
    R d = change + *rest, s = *a + d, t = s - *a;
    *rest = (*a - (s - t)) + (d - t);
    *a = s;
}

static void step(void) {
    for (int i = 0; i < points; i++)
        for (int c = 0; c < 3; c++) {
            half[i].c[c] = v[i].c[c] + H / 2 * f[i].c[c];
            add(&x[i].c[c], &xr[i].c[c], H * half[i].c[c]);
        }
    forces();
    for (int i = 0; i < points; i++)
        for (int c = 0; c < 3; c++) add(&v[i].c[c], &vr[i].c[c], (half[i].c[c] + H / 2 * f[i].c[c]) - v[i].c[c]);
}

static int read_body(const char *path) {
    FILE *file = fopen(path, "r");
    if (!file || fscanf(file, "%d %d", &points, &springs) != 2) return 0;
    Vec **rows[] = {&x, &xr, &v, &vr, &half, &f};
    for (int r = 0; r < 6; r++) *rows[r] = calloc(points, sizeof(Vec));
    spring = calloc(springs, sizeof *spring);
    double a, b, c;
    for (int i = 0; i < points; i++) {
        if (fscanf(file, "%lf %lf %lf", &a, &b, &c) != 3) return 0;
        x[i].c[0] = a; x[i].c[1] = b; x[i].c[2] = c;
    }
    for (int s = 0; s < springs; s++) {
        if (fscanf(file, "%d %d %lf", &spring[s].tail, &spring[s].head, &a) != 3) return 0;
        spring[s].length = a;
    }
    fclose(file);
    return 1;
}

static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * t.tv_sec + t.tv_nsec; }

int main(int argc, char **argv) {
    if (argc < 4 || !read_body(argv[1])) { fprintf(stderr, "springs <file> <steps> <turns>\n"); return 1; }
    int steps = atoi(argv[2]), turns = atoi(argv[3]);
    double least = 1e300;
    forces();
    for (int n = 0; n < turns; n++) {
        double start = now();
        for (int s = 0; s < steps; s++) step();
        double took = (now() - start) / steps / springs;
        if (took < least) least = took;
    }
    printf("%.3f %.12f\n", least, (double)x[0].c[2]);
    return 0;
}
