/* The ball as the example for Arduino draws it. */
#include "ball.h"

uint16_t fixed_in_c(int16_t right, int16_t up) { return ball(right, up); }
