/* The encodings as a C programmer writes them, for comparison with the crate. */
#ifndef ENCODE_H
#define ENCODE_H

#include <stdint.h>

void srgb8_by_powf(const float color[3], uint8_t bytes[3]);
void srgb8_by_table(const float color[3], uint8_t bytes[3]);
uint16_t rgb565_by_powf(const float color[3]);

#endif
