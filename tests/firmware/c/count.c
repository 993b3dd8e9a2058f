/* Prints how many instructions a point light costs, whole and real: the same 8 calls as
   ../src/bin/count.rs, with the same scene and the same count. */
#include <stdint.h>

#include "kernel.h"

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define WIDTH 0xffffffu /* SysTick's */
#define LAMPS 4
#define POINTS 8

#define LAMP(x, y, z) {{x, y, z}, {1.0f, 0.75f, 0.5f}, 1.0f, 0.125f, 0.0625f}

static const point_light lamps[LAMPS] = {
    LAMP(3, 1, 4), LAMP(-2, 2, 5), LAMP(1, -3, 4), LAMP(-1, -1, 6)};

static const vec3 cap[POINTS] = {
    {0, 0, 1},         {0.28f, 0, 0.96f},          {-0.28f, 0, 0.96f},         {0, 0.28f, 0.96f},
    {0, -0.28f, 0.96f}, {0.168f, 0.224f, 0.96f}, {-0.224f, 0.168f, 0.96f}, {0.224f, -0.168f, 0.96f}};

static const material brass = {
    {0.33f, 0.22f, 0.03f}, {0.78f, 0.57f, 0.11f}, {0.99f, 0.94f, 0.81f}, 32};

static int host(int operation, const void *argument) {
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static uint32_t now(void) { return WIDTH - REGISTER(0xe000e018); }

static volatile vec3 result;
static vec3 n;

static void nothing(void) {}
static void thousand(void) { __asm__ volatile(".rept 1000\nnop\n.endr"); }

static void whole(void) {
    vec3 v = {0, 0, 1}, ambient = {0.125f, 0.125f, 0.1875f};
    vec3 shaded = blinn_phong_whole(n, v, n, &brass, ambient, lamps, LAMPS);
    result.x = shaded.x, result.y = shaded.y, result.z = shaded.z;
}

static void real(void) {
    vec3 v = {0, 0, 1}, ambient = {0.125f, 0.125f, 0.1875f};
    vec3 shaded = blinn_phong_real(n, v, n, &brass, ambient, lamps, LAMPS);
    result.x = shaded.x, result.y = shaded.y, result.z = shaded.z;
}

static uint32_t ticks(void (*volatile work)(void)) {
    uint32_t start = now();
    work();
    return (now() - start) & WIDTH;
}

static void print(uint32_t number, char end) {
    char text[12], *first = text + sizeof text;
    *--first = 0, *--first = end;
    do *--first = '0' + number % 10;
    while (number /= 10);
    host(4, first);
}

static uint32_t point_light_of(void (*work)(void)) {
    uint32_t empty = ticks(nothing), per_thousand = ticks(thousand) - empty, sum = 0;
    for (int i = 0; i < POINTS; i++) {
        n = cap[i];
        sum += ticks(work) - empty;
    }
    return (uint32_t)((uint64_t)sum * 1000 / per_thousand / (LAMPS * POINTS));
}

int main(void) {
    REGISTER(0xe000e014) = WIDTH;
    REGISTER(0xe000e018) = 0;
    REGISTER(0xe000e010) = 5;
    while (now() == WIDTH); /* it counts from the next reload on */
    print(point_light_of(whole), ' ');
    print(point_light_of(real), '\n');
    host(0x18, (void *)0x20026); /* a normal end */
    return 0;
}
