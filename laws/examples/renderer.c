/* A renderer to copy from: Lambert, Phong and Blinn-Phong, checked by

       cc -O2 renderer.c -o renderer -lm
       shading-laws ./renderer

   It reads scenes with sscanf, because their members always come in the same order. */
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct { double x, y, z; } Vec;

static Vec add(Vec a, Vec b) { return (Vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static Vec sub(Vec a, Vec b) { return (Vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vec mul(Vec a, Vec b) { return (Vec){a.x * b.x, a.y * b.y, a.z * b.z}; }
static Vec scale(Vec a, double s) { return (Vec){a.x * s, a.y * s, a.z * s}; }
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* a at length 1, or 0 if it has no direction, as L + V where L = -V. */
static Vec unit(Vec a) {
    double length = sqrt(dot(a, a));
    return length > 0 ? scale(a, 1 / length) : a;
}

typedef struct {
    char model[16];
    Vec p, n, v, k_a, k_d, k_s, i_a;
    double m;
} Scene;

typedef struct {
    char kind[16];
    Vec intensity, l, position, attenuation, axis;
    double angle;
} Light;

#define VEC "[%lf,%lf,%lf]"
#define TO(v) &(v).x, &(v).y, &(v).z

/* Reads the members up to the lights, and returns the text that follows. */
static const char *read_scene(const char *text, Scene *s) {
    int end = 0;
    sscanf(text,
           "{\"model\":\"%15[a-z_]\",\"p\":" VEC ",\"n\":" VEC ",\"v\":" VEC ",\"k_a\":" VEC ",\"k_d\":" VEC
           ",\"k_s\":" VEC ",\"m\":%lf,\"i_a\":" VEC ",\"lights\":[%n",
           s->model, TO(s->p), TO(s->n), TO(s->v), TO(s->k_a), TO(s->k_d), TO(s->k_s), &s->m, TO(s->i_a), &end);
    return text + end;
}

/* Reads a light, and returns the text that follows; NULL if there is no light. */
static const char *read_light(const char *text, Light *light) {
    int end = 0;
    if (*text == ',') text++;
    sscanf(text, "{\"kind\":\"%15[a-z]\",\"intensity\":" VEC ",%n", light->kind, TO(light->intensity), &end);
    text += end;
    end = 0;
    /* a format that does not fit the rest leaves `end` as it is */
    sscanf(text, "\"l\":" VEC "}%n", TO(light->l), &end);
    sscanf(text, "\"position\":" VEC ",\"attenuation\":" VEC "}%n", TO(light->position), TO(light->attenuation), &end);
    sscanf(text, "\"position\":" VEC ",\"attenuation\":" VEC ",\"axis\":" VEC ",\"angle\":%lf}%n",
           TO(light->position), TO(light->attenuation), TO(light->axis), &light->angle, &end);
    return end > 0 ? text + end : NULL;
}

/* The intensity that arrives at p, and in `l` the direction to the light. */
static Vec arriving(const Light *light, Vec p, Vec *l) {
    *l = light->l;
    if (strcmp(light->kind, "directional") == 0) return light->intensity;
    Vec to_light = sub(light->position, p), k = light->attenuation;
    double q = sqrt(dot(to_light, to_light));
    *l = scale(to_light, 1 / q);
    if (strcmp(light->kind, "spot") == 0 && -dot(*l, light->axis) < cos(light->angle))
        return (Vec){0, 0, 0}; /* outside the cone, to which the edge belongs */
    return scale(light->intensity, 1 / (k.x + k.y * q + k.z * q * q));
}

static double highlight(const Scene *s, Vec n, Vec l, Vec v) {
    if (strcmp(s->model, "phong") == 0) {
        Vec r = sub(scale(n, 2 * dot(n, l)), l);
        return pow(fmax(0, dot(r, v)), s->m);
    }
    if (strcmp(s->model, "blinn_phong") == 0) return pow(fmax(0, dot(n, unit(add(l, v)))), s->m);
    return 0; /* Lambert */
}

static Vec shade(const char *text) {
    Scene s = {0};
    Light light = {0};
    text = read_scene(text, &s);
    Vec n = unit(s.n), v = unit(s.v), color = mul(s.k_a, s.i_a), l;
    while ((text = read_light(text, &light))) {
        Vec intensity = arriving(&light, s.p, &l);
        double n_dot_l = dot(n, l);
        if (n_dot_l <= 0) continue; /* the light is behind the surface */
        Vec reflected = add(scale(s.k_d, n_dot_l), scale(s.k_s, highlight(&s, n, l, v)));
        color = add(color, mul(intensity, reflected));
    }
    return color;
}

int main(void) {
    static char line[65536];
    if (!fgets(line, sizeof line, stdin)) return 1; /* the version of the format */
    puts("{\"name\":\"renderer.c\",\"roundoff\":1.1102230246251565e-16}");
    fflush(stdout);
    while (fgets(line, sizeof line, stdin)) {
        if (line[0] == '\n') { /* the end of a batch */
            fflush(stdout);
            continue;
        }
        Vec color = shade(line);
        printf("[%.17g,%.17g,%.17g]\n", color.x, color.y, color.z);
    }
}
