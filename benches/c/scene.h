/* The data that versus/c.rs passes. */
#include <stddef.h>

struct lamp {
    float position[3], intensity[3];
};

struct scene {
    const struct lamp *lamps;
    size_t lamp_count;
    float attenuation[3];
    float k_a[3], k_d[3], k_s[3], ambient[3];
    float m;
};
